#pragma once

// Point and Pose: a position, and a position with a heading, in grid coordinates: a cell has the size 1.
// MapPoint and MapPose (map_pose.hpp) are in metres.

#include <cmath>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {

/// A position in grid coordinates.
struct Point {
  double x = 0;  // cells
  double y = 0;  // cells

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

/// A position and a heading in grid coordinates.
struct Pose {
  double x = 0;        // cells
  double y = 0;        // cells
  double heading = 0;  // radians, counter-clockwise from +x

  /// The position alone.
  constexpr Point point() const { return {x, y}; }

  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

/// The centre of a cell, in grid coordinates.
constexpr Point centre_of(Cell cell) { return {cell.x + 0.5, cell.y + 0.5}; }

/// The cell that contains a point in grid coordinates. The coordinates are finite and fit into a Cell.
inline Cell cell_at(Point point) {
  return {static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y))};
}

/// The pose at a cell's centre, in grid coordinates.
constexpr Pose pose_at(Cell cell, double heading = 0) {
  return {cell.x + 0.5, cell.y + 0.5, heading};
}

/// Euclidean distance in cells.
inline double distance(Point a, Point b) { return hypotenuse(a.x - b.x, a.y - b.y); }

}  // namespace wend
