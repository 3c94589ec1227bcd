#pragma once

// PathMetrics: how long a path is, how much and how tightly it turns, and how near to obstacles it
// comes.

#include "wend/map/free_space.hpp"
#include "wend/path/corner_rounding.hpp"
#include "wend/path/path.hpp"

namespace wend {

struct PathMetrics {
  double length = 0;  // cells, as Path::length()

  /// Sum of the absolute changes of heading, radians; of a driven path what its arcs turn. Where a
  /// path of cells or waypoints turns back, that is pi; a car that changes gear keeps its heading.
  double turning = 0;

  /// The least radius of a driven path's arcs; of cells and waypoints 0 if there is a corner, for
  /// nothing that steers can follow one. Infinite of a straight path. Cells.
  double smallest_turning_radius = 0;

  /// The same with every corner rounded by an arc that keeps within `corner_rounding` of it
  /// (corner_rounding.hpp): a robot that can turn so tightly follows the path, no farther from it
  /// than that. So it is never more than what a curve has from which the points were taken, and
  /// nearly that where they are dense: no farther from each other than sqrt(8 radius rounding).
  double rounded_turning_radius = 0;
  double corner_rounding = 0;  // cells

  int reversals = 0;  // changes between ahead and reverse; 0 unless it is driven

  /// From the path to the nearest closed obstacle square, in cells; infinite without obstacles.
  /// The smallest one is exact over all points of the way, 0 where it touches an obstacle: of the
  /// line through the cell centres (a diagonal step that cuts a corner), or of the arcs and lines of
  /// other paths. The mean is over the length, taken to be linear (trapezoid rule) from centre to
  /// centre, or between points that cut each arc or line into equal pieces of at most one cell; of a
  /// path that goes nowhere it is the clearance where it stands.
  double smallest_clearance = 0;
  double mean_clearance = 0;
};

/// Measures a path (not empty) whose cells are on the map; poses and waypoints may also be on its
/// border or outside of it. It need not be passable: inside obstacles the clearance is 0. O(cells) for steps to
/// neighbouring cells; longer ones as way_clearance(), and each cell's length of an arc as
/// arc_clearance().
PathMetrics measure(const Path& path, const FreeSpace& space,
                    double corner_rounding = kCornerRounding);

}  // namespace wend
