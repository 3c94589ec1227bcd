#pragma once

// Polygon: a simple polygon, the outline of a robot. Its edges meet only where one follows the other,
// and it has an area.
//
//   const auto box = wend::Polygon::make({{0.4, 0.25}, {-0.3, 0.25}, {-0.3, -0.25}, {0.4, -0.25}});
//   if (!box) return report(box.error().message);
//   const double gap = wend::distance_to_outline(*box, {0, 0});  // 0.25
//
// Corners are in one coordinate system: a robot's, in metres, or the grid's. Immutable. Cheap to move;
// a copy copies the corners.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

class Polygon {
 public:
  static constexpr std::size_t kMostCorners = 64;
  static constexpr double kLargestCoordinate = 1e6;

  /// In either sense of rotation. A last corner that repeats the first one is left out. Refused:
  /// fewer than 3 corners or more than kMostCorners, a coordinate that is NaN or larger than
  /// kLargestCoordinate, two equal corners in a row, edges that cross or touch. O(corners^2).
  static Expected<Polygon, Error> make(std::vector<Point> corners);

  /// From 3 to kMostCorners, counter-clockwise (from +x to +y).
  const std::vector<Point>& corners() const { return corners_; }

  /// From corner i to the next one.
  Line edge(std::size_t i) const { return {corners_[i], corners_[(i + 1) % corners_.size()]}; }

  double area() const;

  /// Is the point inside or on the outline? O(corners).
  bool contains(Point point) const;

  /// All coordinates times a finite factor greater than 0.
  Polygon scaled(double factor) const;

  friend bool operator==(const Polygon&, const Polygon&) = default;

 private:
  explicit Polygon(std::vector<Point> corners) : corners_(std::move(corners)) {}

  std::vector<Point> corners_;
};

/// From a point, inside or outside, to the nearest point of the outline. O(corners).
double distance_to_outline(const Polygon& polygon, Point point);

/// From a point to the farthest point of the polygon. O(corners).
double farthest_distance(const Polygon& polygon, Point point);

/// Is a point inside the simple polygon with these corners? On the outline it may be either. O(corners).
bool is_inside(std::span<const Point> corners, Point point);

}  // namespace wend
