#pragma once

// Line: the line segment between two points, and its distance to points and to squares of cells.
//
//   const wend::Line line{{0.5, 0.5}, {3.5, 0.5}};
//   const double gap = wend::distance(line, wend::Cell{2, 2});  // 1.5
//
// O(1), exact up to rounding. Both ends may be the same point.

#include <cmath>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {

/// The line segment between two points.
template <class PointType>
struct BasicLine {
  PointType from;  // one end
  PointType to;    // the other end

  /// The distance between the ends.
  double length() const { return distance(from, to); }
  /// The direction from `from` to `to` in radians; 0 if both are the same point.
  double heading() const { return arc_tangent(to.y - from.y, to.x - from.x); }
  /// The point halfway.
  PointType middle() const { return {(from.x + to.x) / 2, (from.y + to.y) / 2}; }
  /// The point after a share of the line, from 0 to 1.
  PointType at(double share) const {
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
  }
};

/// A line in grid coordinates.
using Line = BasicLine<Point>;

/// The distance from a point to the nearest point of the line.
WEND_API double distance(const Line& line, Point point);

/// The distance to the closed square of a cell; 0 if the line touches it, crosses it or lies inside.
WEND_API double distance(const Line& line, Cell square);

}  // namespace wend
