#pragma once

// A small map on which a path bends.

namespace wend::test {

inline constexpr const char* kCorridorGrid =
    "..........\n"
    ".####.....\n"
    ".#........\n"
    "...#####..\n"
    "..........\n";

}  // namespace wend::test
