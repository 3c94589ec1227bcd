#pragma once

// coarse_size: how large the squares of a CoarseGrid may be, so that estimates do not pass through walls.

#include "wend/map/bit_grid.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The largest size of a square, in cells, for which no wall is lost, and at most `most`. The radius of the robot
/// tells how thick walls are at least. A map may have thicker ones, as the inflated costmap of a robot whose
/// centre is planned for: so larger squares are tried, and taken if no more than one of a thousand falls apart into
/// drivable cells that are not connected within it. O(cells / size) for each size tried.
int coarse_size(const FreeSpace& space, const BitGrid& drivable, double most);

}  // namespace wend
