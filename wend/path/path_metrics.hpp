#pragma once

// PathMetrics: the length, turning, turning radius and clearance of a path. Corner: the widest arc
// that rounds a corner of it.
//
// A new metric is a member of PathMetrics, a line in metrics_of() and what measure() does for it.

#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/metric.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The default window, in cells: far below the accuracy of obstacles in a map, and enough for
/// points a cell apart on every circle of more than 1.25 cells.
inline constexpr double kCornerRounding = 0.1;

/// The corner of two lines, rounded: the widest arc that joins them and keeps within a window of the
/// corner.
///
///   const wend::Corner corner({0, 0}, {1, 0}, {1, 1});
///   const double radius = corner.radius(0.1);  // 0.24: 0.1 / (sqrt(2) - 1)
///
/// A corner has radius 0: nothing that steers can drive it. Rounded it has one, and a robot that can
/// turn that tightly comes no farther from the corner than the window. The arc touches both lines no
/// farther from the corner than the middle of the shorter one, so that arcs of successive corners never
/// overlap: a polyline whose corners are all rounded is a curve that can be driven. Of points sampled
/// from a circle at even distances, the arc is narrower than the circle by the factor cos(turn / 2), so
/// that the radius is never overstated, and approached where the points are dense.
class WEND_API Corner {
 public:
  /// At `at`, between lines from `from` and to `to`; both have a length. A turn of less than a
  /// nanoradian is rounding: straight on.
  Corner(Point from, Point at, Point to);

  /// The tangent of half the change of heading: 0 straight on, infinite straight back.
  double half_turn_tangent() const { return half_turn_; }

  /// The radius of the widest arc, in the unit of the points: infinite for a straight line, 0 for a
  /// turn back and for a window of 0.
  double radius(double window) const;

  /// The largest half_turn_tangent() that an arc of that radius (>= 0) rounds within the window.
  double widest_half_turn(double radius, double window) const;

 private:
  double half_turn_;
  double tangent_;  // how far from the corner an arc may begin
};

struct PathMetrics {
  double length = 0;  // cells, as Path::length()

  /// Sum of the absolute changes of heading, radians; for a car's path, of its arcs. A path of
  /// cells or waypoints that turns back counts pi; a car that changes gear keeps its heading.
  double turning = 0;

  /// The least radius of a car's arcs, in cells. For cells and waypoints it is 0 if there is a
  /// corner, because a steered robot cannot follow one. Infinite for a straight path.
  double smallest_turning_radius = 0;

  /// The same with every corner rounded by an arc that keeps within `corner_rounding` of it
  /// (Corner): a robot that can turn so tightly follows the path, no farther from it
  /// than that. So it is never more than what a curve has from which the points were taken, and
  /// nearly that where they are dense: no farther from each other than sqrt(8 radius rounding).
  double rounded_turning_radius = 0;
  double corner_rounding = 0;  // cells

  int reversals = 0;  // changes between forwards and reverse; 0 except for a car's path

  /// From the path to the nearest closed obstacle square, in cells; infinite without obstacles.
  /// The smallest one is exact over all points of the way, 0 where it touches an obstacle: of the
  /// line through the cell centres (a diagonal step that cuts a corner), or of the arcs and lines of
  /// other paths. The mean is over the length, taken to be linear (trapezoid rule) from centre to
  /// centre of neighbouring cells, or between points that cut each arc or line into equal pieces of at most one cell; of a
  /// path that goes nowhere it is the clearance where it stands.
  double smallest_clearance = 0;
  double mean_clearance = 0;  // cells

  /// The largest distance of a point of the path from the straight line between its ends, in cells: how far it goes out
  /// of the way. Exact for lines and arcs; 0 for a straight path and for one that goes nowhere.
  double deviation = 0;
};

/// All of them, each once, with names, units and meanings: what reports and front ends show, in this order.
WEND_API std::vector<Metric> metrics_of(const PathMetrics& metrics);

/// Measures a path. It may lead along the border of the map and off it (cells then count as their middles), and need
/// not be passable: inside obstacles the clearance is 0. Fails as fault_of() does (path_fault.hpp), and with
/// invalid_option for a window that is not finite or negative. O(cells) for steps to neighbouring cells; longer ones
/// as way_clearance(), and each cell's length of an arc as arc_clearance().
WEND_API Expected<PathMetrics, Error> measure(const Path& path, const FreeSpace& space,
                                              double corner_rounding = kCornerRounding);

}  // namespace wend
