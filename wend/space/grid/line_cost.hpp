#pragma once

// The cost of a straight line between the centres of two cells: the length in each cell that it crosses, times
// the cell's multiplier. For two neighbours that is what a step costs.
//
//   const double cost = wend::line_cost(space, {0, 4}, {3, 6});
#include <span>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The cost in cells. A line may cross cells in whose middle the robot does not fit: they cost as where it
/// touches an obstacle. All cells of the line are on the map. O(length).
WEND_API double line_cost(const FreeSpace& space, Cell from, Cell to);

/// The sum over a path whose cells are joined by lines.
WEND_API double any_angle_path_cost(const FreeSpace& space, std::span<const Cell> cells);

}  // namespace wend
