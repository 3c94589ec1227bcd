#pragma once

#include <cstdint>

#include "wend/map/bit_grid.hpp"

namespace wend {

/// About how many nanoseconds it takes to find the ConnectedComponents of these cells, from a sample of them. O(1).
std::uint64_t labelling_time(const BitGrid& cells);

}  // namespace wend
