#pragma once

// Exact distances from the centre of each cell to the nearest closed blocked square.
//
// In half-cell units the squares of these distances are integers: a square k columns and l rows away
// lies max(0, 2k-1) and max(0, 2l-1) half-cells from the centre. So they can be compared exactly. A
// field of distances between cell centres would be wrong by up to 0.7 cells.

#include <cstddef>
#include <cstdint>

#include "wend/base/deadline.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"

namespace wend {

/// Larger than any distance that a field holds (32768 cells): there is no obstacle, or none near.
inline constexpr std::uint32_t kNoObstacle = UINT32_MAX;

/// Converts such a squared distance to a distance in cells; infinite for kNoObstacle.
double distance_in_cells(std::uint32_t squared_half_cells);

/// For each cell the squared distance, in half-cell units, from its centre to the nearest closed square
/// of a set cell of `blocked`; 0 in a set cell. The outside of the map does not count.
///
/// O(cells): two passes, columns and then rows, as in A. Meijster, J. Roerdink and W. Hesselink, "A
/// General Algorithm for Computing Distance Transforms in Linear Time", 2000.
Grid<std::uint32_t> squared_half_cell_distances(const BitGrid& blocked,
                                                DeadlineCheck& stop = DeadlineCheck::never());

/// The same for one cell, at most `most`. Adds the number of words that it reads to `words`. O(rows that are
/// nearer than the result, times their words).
std::uint32_t squared_half_cell_distance(const BitGrid& blocked, Cell from, std::uint32_t most,
                                         std::size_t& words);

}  // namespace wend
