#pragma once

// Simple polygons at random that contain the origin: star-shaped around it, convex or not, and the
// same with a notch; or beside it.

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/polygon.hpp"
#include "wend/geometry/pose.hpp"

namespace wend::test {

/// Where a point of the robot's coordinates is when the robot stands at a pose.
inline Point placed(Point of_robot, const Pose& pose) {
  const double cosine = std::cos(pose.heading);
  const double sine = std::sin(pose.heading);
  return {pose.x + cosine * of_robot.x - sine * of_robot.y,
          pose.y + sine * of_robot.x + cosine * of_robot.y};
}

/// Corners are from 0.1 to `largest` away from the origin.
inline Polygon random_polygon(double largest = 2) {
  for (;;) {
    const int corners = *rc::gen::inRange(3, 10);
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) {
      const double jitter = *rc::gen::inRange(0, 80) / 100.0;
      const double angle = 2 * kPi * (i + jitter) / corners;
      const double radius = 0.1 + (largest - 0.1) * *rc::gen::inRange(0, 101) / 100.0;
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const auto polygon = Polygon::make(points);
    if (polygon && polygon->contains({0, 0})) return *polygon;
  }
}

/// A rectangle or an L with corners on a fine lattice: edges that touch and run along squares.
inline Polygon random_right_angled_polygon() {
  const auto draw = [] { return *rc::gen::inRange(1, 8) / 4.0; };
  const double left = -draw();
  const double right = draw();
  const double low = -draw();
  const double high = draw();
  if (*rc::gen::arbitrary<bool>()) {
    return *Polygon::make({{left, low}, {right, low}, {right, high}, {left, high}});
  }
  return *Polygon::make(
      {{left, low}, {right, low}, {right, 0}, {right / 2, 0}, {right / 2, high}, {left, high}});
}

/// The same beside the origin or with it on an edge, at most some cells away.
inline Polygon moved_off_the_origin(const Polygon& polygon) {
  double low = polygon.corners().front().x;
  for (const Point corner : polygon.corners()) low = std::min(low, corner.x);
  const double gap = *rc::gen::inRange(0, 9) / 4.0;
  const double angle = *rc::gen::inRange(-3, 4) * kPi / 4;
  std::vector<Point> corners;
  for (const Point corner : polygon.corners()) {
    corners.push_back(placed({corner.x - low + gap, corner.y}, {0, 0, angle}));
  }
  return *Polygon::make(std::move(corners));
}

/// Any of these, around the origin, beside it or with the origin on an edge.
inline Polygon random_outline(double largest = 2) {
  const Polygon polygon =
      *rc::gen::arbitrary<bool>() ? random_polygon(largest) : random_right_angled_polygon();
  return *rc::gen::arbitrary<bool>() ? polygon : moved_off_the_origin(polygon);
}

}  // namespace wend::test
