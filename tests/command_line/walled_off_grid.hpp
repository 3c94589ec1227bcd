#pragma once

// A small map of two components: the right column is walled off.

namespace wend::test {

inline constexpr const char* kWalledOff =
    ".....#.\n"
    ".###.#.\n"
    "....##.\n"
    ".~3..#?\n";

}  // namespace wend::test
