#pragma once

// Whether a disc that moves along a line meets an obstacle: the rectangle that it sweeps, as an interval of cells in each
// row of the map, 64 cells at a time.

#include <optional>

#include "wend/geometry/line.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// Does the robot's disc fit along a line at both of whose ends it fits? Nothing where an obstacle touches the disc, up to
/// rounding, or the line is nearly parallel to an axis. O(rows that the disc passes + cells passed / 64).
std::optional<bool> disc_fits_by_rows(const FreeSpace& space, const Line& line);

}  // namespace wend
