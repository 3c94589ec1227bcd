#pragma once

// Polygon: a simple polygon, the outline of a robot. Only consecutive edges meet, at their common
// corner, and the area is not zero.
//
//   const auto box = wend::Polygon::make({{0.4, 0.25}, {-0.3, 0.25}, {-0.3, -0.25}, {0.4, -0.25}});
//   if (!box) return report(box.error().message);
//   const double gap = wend::distance_to_outline(*box, {0, 0});  // 0.25
//
// All corners are in one coordinate system: the robot's, in metres, or the grid's. Immutable. Cheap to
// move; a copy copies the corners. What tests a polygon takes time linear in its corners.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

class WEND_API Polygon {
 public:
  static constexpr std::size_t kMostCorners =
      4096;  // the most corners of a polygon: a test of one pose reads them all
  static constexpr double kLargestCoordinate = 1e6;  // of a corner, either sign

  /// Takes corners in either orientation. Of equal corners in a row all but the first are dropped, and so is a last
  /// corner that repeats the first one. Corners may lie on a line with their neighbours. Rejects fewer than 3 corners
  /// or more than kMostCorners, a coordinate that is NaN or larger than kLargestCoordinate, edges that cross or touch;
  /// messages count corners as they are given. O(corners log corners) if few edges lie above each other, at most
  /// O(corners^2).
  static Expected<Polygon, Error> make(std::vector<Point> corners);

  /// 3 to kMostCorners corners, counter-clockwise (from +x to +y).
  const std::vector<Point>& corners() const { return corners_; }

  /// The edge from corner i to the next one.
  Line edge(std::size_t i) const { return {corners_[i], corners_[(i + 1) % corners_.size()]}; }

  /// The area, in squares of the coordinates' unit; greater than 0. O(corners).
  double area() const;

  /// Is the point inside or on the outline? O(corners).
  bool contains(Point point) const;

  /// Multiplies all coordinates by a finite factor greater than 0.
  Polygon scaled(double factor) const;

  friend bool operator==(const Polygon&, const Polygon&) = default;

 private:
  explicit Polygon(std::vector<Point> corners) : corners_(std::move(corners)) {}

  std::vector<Point> corners_;
};

/// The distance from a point, inside or outside, to the nearest point of the outline. O(corners).
WEND_API double distance_to_outline(const Polygon& polygon, Point point);

/// The distance from a point to the farthest point of the polygon. O(corners).
WEND_API double farthest_distance(const Polygon& polygon, Point point);

/// Is a point inside the simple polygon with these corners? For points on the outline the answer may be
/// either. O(corners).
WEND_API bool is_inside(std::span<const Point> corners, Point point);

}  // namespace wend
