#include "wend/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace wend {
namespace {

/// Twice the area of the triangle a, b, c; positive where c is to the left of a to b.
double cross(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double twice_signed_area(const std::vector<Point>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += cross(corners.front(), corners[i], corners[(i + 1) % corners.size()]);
  }
  return sum;
}

/// Do two closed lines have a point in common?
bool touch(const Line& a, const Line& b) {
  const double from = cross(b.from, b.to, a.from);
  const double to = cross(b.from, b.to, a.to);
  const double other_from = cross(a.from, a.to, b.from);
  const double other_to = cross(a.from, a.to, b.to);
  if (((from < 0 && to > 0) || (from > 0 && to < 0)) &&
      ((other_from < 0 && other_to > 0) || (other_from > 0 && other_to < 0))) {
    return true;
  }
  const auto on = [](double side, const Line& line, Point point) {
    return side == 0 && std::min(line.from.x, line.to.x) <= point.x &&
           point.x <= std::max(line.from.x, line.to.x) &&
           std::min(line.from.y, line.to.y) <= point.y &&
           point.y <= std::max(line.from.y, line.to.y);
  };
  return on(from, b, a.from) || on(to, b, a.to) || on(other_from, a, b.from) ||
         on(other_to, a, b.to);
}

/// Does b, which begins at the end of a, go back along a?
bool goes_back(const Line& a, const Line& b) {
  const double along =
      (a.to.x - a.from.x) * (b.to.x - b.from.x) + (a.to.y - a.from.y) * (b.to.y - b.from.y);
  return cross(a.from, a.to, b.to) == 0 && along < 0;
}

std::string corner_name(std::size_t i) { return "corner " + std::to_string(i + 1); }

bool in_range(double number) { return std::abs(number) <= Polygon::kLargestCoordinate; }

std::optional<Error> fault_of_corner(const std::vector<Point>& corners, std::size_t i) {
  if (!in_range(corners[i].x) || !in_range(corners[i].y)) {
    return Error{Status::invalid_option,
                 corner_name(i) + " has a coordinate that is NaN or not between -1e6 and 1e6",
                 corner_name(i)};
  }
  if (corners[i] != corners[(i + 1) % corners.size()]) return std::nullopt;
  return Error{Status::invalid_option,
               corner_name(i) + " and the corner after it are the same point", corner_name(i)};
}

std::optional<Error> crossing_edges(const std::vector<Point>& corners) {
  const std::size_t n = corners.size();
  const auto edge = [&](std::size_t i) { return Line{corners[i], corners[(i + 1) % n]}; };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool follows = j == i + 1;
      const bool precedes = i == 0 && j == n - 1;
      const bool wrong = follows    ? goes_back(edge(i), edge(j))
                         : precedes ? goes_back(edge(j), edge(i))
                                    : touch(edge(i), edge(j));
      if (!wrong) continue;
      return Error{Status::invalid_option,
                   "the edges that begin at corners " + std::to_string(i + 1) + " and " +
                       std::to_string(j + 1) + " cross or touch: a polygon must be simple",
                   corner_name(i)};
    }
  }
  return std::nullopt;
}

}  // namespace

Expected<Polygon, Error> Polygon::make(std::vector<Point> corners) {
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  if (corners.size() < 3 || corners.size() > kMostCorners) {
    return failure(Status::invalid_option, "a polygon has 3 to " + std::to_string(kMostCorners) +
                                               " corners, not " + std::to_string(corners.size()));
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (auto fault = fault_of_corner(corners, i)) return Unexpected<Error>(*std::move(fault));
  }
  if (auto fault = crossing_edges(corners)) return Unexpected<Error>(*std::move(fault));
  if (twice_signed_area(corners) < 0) {
    std::reverse(corners.begin() + 1, corners.end());
    // Rounding depends on the order, and the corners of a valid polygon must be valid in its own.
    if (auto fault = crossing_edges(corners)) return Unexpected<Error>(*std::move(fault));
  }
  if (!(twice_signed_area(corners) > 0)) {
    return failure(Status::invalid_option, "the polygon has no area");
  }
  return Polygon(std::move(corners));
}

double Polygon::area() const { return twice_signed_area(corners_) / 2; }

bool Polygon::contains(Point point) const {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (touch(edge(i), Line{point, point})) return true;
  }
  return is_inside(corners_, point);
}

Polygon Polygon::scaled(double factor) const {
  std::vector<Point> corners = corners_;
  for (Point& corner : corners) corner = {corner.x * factor, corner.y * factor};
  return Polygon(std::move(corners));
}

double distance_to_outline(const Polygon& polygon, Point point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.corners().size(); ++i) {
    least = std::min(least, distance(polygon.edge(i), point));
  }
  return least;
}

double farthest_distance(const Polygon& polygon, Point point) {
  double most = 0;
  for (const Point corner : polygon.corners()) most = std::max(most, distance(corner, point));
  return most;
}

// Counts the edges to the right of the point that cross its height.
bool is_inside(std::span<const Point> corners, Point point) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point from = corners[i];
    const Point to = corners[i + 1 == corners.size() ? 0 : i + 1];
    if ((from.y > point.y) == (to.y > point.y)) continue;
    if ((cross(from, to, point) > 0) == (to.y > from.y)) inside = !inside;
  }
  return inside;
}

}  // namespace wend
