#pragma once

// How much of a robot's polygon lies in blocked squares, by brute force: it clips the polygon by each
// of them and looks at the area that is left. It shares nothing with the code that it checks.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/testing/random_polygon.hpp"
#include "wend/geometry/polygon.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::test {

/// What of a polygon lies where x * point.x + y * point.y <= limit (Sutherland and Hodgman).
inline std::vector<Point> clipped(const std::vector<Point>& polygon, double x, double y,
                                  double limit) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    const double from = x * a.x + y * a.y - limit;
    const double to = x * b.x + y * b.y - limit;
    if (from <= 0) kept.push_back(a);
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) {
      const double share = from / (from - to);
      kept.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    }
  }
  return kept;
}

inline double area_of(const std::vector<Point>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

inline std::vector<Point> corners_at(const Polygon& outline, const Pose& pose) {
  std::vector<Point> corners;
  for (const Point corner : outline.corners()) corners.push_back(placed(corner, pose));
  return corners;
}

/// The area that a polygon has in common with a square; with a margin around it if that is given.
inline double common_area(const std::vector<Point>& corners, Cell square, double margin = 0) {
  auto rest = clipped(corners, 1, 0, square.x + 1 + margin);
  rest = clipped(rest, -1, 0, margin - square.x);
  rest = clipped(rest, 0, 1, square.y + 1 + margin);
  return area_of(clipped(rest, 0, -1, margin - square.y));
}

/// The blocked squares, and those around the map if its outside is blocked.
inline std::vector<Cell> blocked_squares(const FreeSpace& space) {
  std::vector<Cell> squares;
  for (int y = -8; y < space.height() + 8; ++y) {
    for (int x = -8; x < space.width() + 8; ++x) {
      const bool blocked = space.contains({x, y}) ? space.obstacles().blocked()[{x, y}]
                                                  : space.outside() == OutsidePolicy::blocked;
      if (blocked) squares.push_back({x, y});
    }
  }
  return squares;
}

/// The most of the polygon that lies in one blocked square, or in one grown by a margin.
inline double worst_overlap(const FreeSpace& space, const std::vector<Cell>& blocked,
                            const Pose& pose, double margin = 0) {
  const auto corners = corners_at(*space.outline(), pose);
  const double reach = space.radius_in_cells() + margin + 1;
  double worst = 0;
  for (const Cell square : blocked) {
    const bool far =
        std::abs(square.x + 0.5 - pose.x) > reach || std::abs(square.y + 0.5 - pose.y) > reach;
    if (!far) worst = std::max(worst, common_area(corners, square, margin));
  }
  return worst;
}

}  // namespace wend::test
