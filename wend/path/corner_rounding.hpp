#pragma once

// The corner of two lines, rounded: the widest arc that joins them and keeps within a window of the
// corner.
//
//   const wend::Corner corner({0, 0}, {1, 0}, {1, 1});
//   const double radius = corner.radius(0.1);  // 0.24: 0.1 / (sqrt(2) - 1)
//
// A corner has radius 0: nothing that steers can drive it. Rounded it has one, and a robot that can
// turn that tightly comes no farther from the corner than the window. The arc touches both lines no
// farther from the corner than the middle of the shorter one, so that arcs of successive corners never
// overlap: a polyline whose corners are all rounded is a curve that can be driven. Of points sampled
// from a circle at even distances, the arc is narrower than the circle by the factor cos(turn / 2), so
// that the radius is never overstated, and approached where the points are dense.

#include "wend/geometry/pose.hpp"

namespace wend {

/// The window unless somebody says otherwise, in cells: far less than a map knows of its obstacles, and
/// enough for points a cell apart on every circle of more than 1.25 cells.
inline constexpr double kCornerRounding = 0.1;

class Corner {
 public:
  /// At `at`, between lines from `from` and to `to`; both have a length. A turn of less than a
  /// nanoradian is rounding: straight on.
  Corner(Point from, Point at, Point to);

  /// The tangent of half the change of heading: 0 straight on, infinite straight back.
  double half_turn_tangent() const { return half_turn_; }

  /// Of the widest arc, in the unit of the points: infinite where the lines go straight on, 0 where
  /// they turn back and with a window of 0.
  double radius(double window) const;

  /// The largest half_turn_tangent() that an arc of that radius (>= 0) rounds within the window.
  double widest_half_turn(double radius, double window) const;

 private:
  double half_turn_;
  double tangent_;  // how far from the corner an arc may begin
};

}  // namespace wend
