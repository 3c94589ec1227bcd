#pragma once

// PathMetrics: how long a path is, how much it turns, and how near to obstacles it comes.

#include "wend/map/free_space.hpp"
#include "wend/path/path.hpp"

namespace wend {

struct PathMetrics {
  double length = 0;   // cells, as Path::length()
  double turning = 0;  // sum of the absolute changes of heading, radians; turning back is pi

  /// From the path to the nearest closed obstacle square, in cells; infinite without obstacles.
  /// The smallest one is exact over all points of the line through the cell centres, 0 where it
  /// touches an obstacle (a diagonal step that cuts a corner). The mean is over its length, taken to
  /// be linear from centre to centre (trapezoid rule); of a path that goes nowhere it is the
  /// clearance where it stands.
  double smallest_clearance = 0;
  double mean_clearance = 0;
};

/// Measures a path whose cells are on the map (not empty). It need not be passable: inside obstacles
/// the clearance is 0. O(cells) for steps to neighbouring cells; longer ones as way_clearance().
PathMetrics measure(const Path& path, const FreeSpace& space);

}  // namespace wend
