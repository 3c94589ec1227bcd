#pragma once

// Noise: maps of small obstacles that lie scattered, where a jump ends after a few cells, so that a search from cell to
// cell is as fast and needs less memory.

#include "wend/map/bit_grid.hpp"

namespace wend {

/// Is a map of these free cells noise? Looks at some 512 words of it: O(1).
bool is_noise(const BitGrid& free);

}  // namespace wend
