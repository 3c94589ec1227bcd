#pragma once

// The cost and the validity of a path of cells, recomputed from the path alone, never from the sums of
// a search.

#include <cstddef>
#include <span>
#include <string>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// The first error in a path.
struct PathFault {
  std::size_t index;  // of the cell at fault
  std::string what;   // "cell (3,4) is an obstacle", "(3,4) to (5,4) is no step"
};

/// Sums, over all steps, length times the mean terrain multiplier of the two cells. On uniform terrain
/// steps are counted, so paths of equal length cost the same to the last bit.
double grid_path_cost(const FreeSpace& space, std::span<const Cell> cells);

/// The cost of a path, if every cell is passable and every step legal. O(length).
WEND_API Expected<double, PathFault> check_grid_path(const FreeSpace& space, GridMoves moves,
                                                     std::span<const Cell> cells);

/// The cost of a path of an any-angle planner, which is its length on uniform terrain, if every cell is passable and every line between two
/// of them free, by the rules of disc_fits_along(). O(length).
WEND_API Expected<double, PathFault> check_any_angle_path(const FreeSpace& space,
                                                          Adjacency adjacency,
                                                          std::span<const Cell> cells);

/// The same for waypoints, in grid coordinates, on uniform terrain. A point does not turn between two obstacles that
/// touch at a corner unless `adjacency` is edges_and_corners.
WEND_API Expected<double, PathFault> check_any_angle_path(const FreeSpace& space,
                                                          Adjacency adjacency,
                                                          std::span<const Point> waypoints);

}  // namespace wend
