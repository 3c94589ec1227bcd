#include "wend/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
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

bool in_range(double number) { return std::abs(number) <= Polygon::kLargestCoordinate; }

/// The corners of an outline, and the number of each in the list that was given, counted from 1.
struct Outline {
  std::vector<Point> corners;
  std::vector<std::size_t> numbers;

  std::size_t size() const { return corners.size(); }
  Line edge(std::size_t i) const { return {corners[i], corners[(i + 1) % size()]}; }
  std::string name(std::size_t i) const { return "corner " + std::to_string(numbers[i]); }
};

std::optional<Error> fault_of_numbers(const std::vector<Point>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (in_range(corners[i].x) && in_range(corners[i].y)) continue;
    const std::string name = "corner " + std::to_string(i + 1);
    return Error{Status::invalid_option,
                 name + " has a coordinate that is NaN or not between -1e6 and 1e6", name};
  }
  return std::nullopt;
}

/// Drops corners that repeat the one before them, the first one after the last.
Outline without_repeated(const std::vector<Point>& corners) {
  Outline outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!outline.corners.empty() && outline.corners.back() == corners[i]) continue;
    outline.corners.push_back(corners[i]);
    outline.numbers.push_back(i + 1);
  }
  while (outline.size() > 1 && outline.corners.front() == outline.corners.back()) {
    outline.corners.pop_back();
    outline.numbers.pop_back();
  }
  return outline;
}

std::optional<Error> fault_of_count(const Outline& outline, std::size_t given) {
  if (outline.size() >= 3 && outline.size() <= Polygon::kMostCorners) return std::nullopt;
  std::string message = "a polygon has 3 to " + std::to_string(Polygon::kMostCorners) +
                        " corners, not " + std::to_string(outline.size());
  if (outline.size() < given) {
    message += " (" + std::to_string(given) + " with those that repeat the one before)";
  }
  return Error{Status::invalid_option, std::move(message)};
}

/// Of two edges that meet where they must not, i < j: why that is wrong.
Error crossing_error(const Outline& outline, std::size_t i, std::size_t j) {
  const std::string numbers =
      std::to_string(outline.numbers[i]) + " and " + std::to_string(outline.numbers[j]);
  const bool follows = j == i + 1;
  const bool precedes = i == 0 && j + 1 == outline.size();
  const std::string why =
      follows || precedes ? "the outline turns back on itself at " + outline.name(follows ? j : i)
                          : std::string("a polygon must be simple");
  return {Status::invalid_option,
          "the edges that begin at corners " + numbers + " cross or touch: " + why,
          outline.name(i)};
}

bool meet_wrongly(const Outline& outline, std::size_t i, std::size_t j) {
  if (j == i + 1) return goes_back(outline.edge(i), outline.edge(j));
  if (i == 0 && j + 1 == outline.size()) return goes_back(outline.edge(j), outline.edge(i));
  return touch(outline.edge(i), outline.edge(j));
}

/// The first two edges that cross, if any do. Compares only edges that have an x in common.
std::optional<Error> crossing_edges(const Outline& outline) {
  const auto low = [&](std::size_t i) {
    return std::min(outline.edge(i).from.x, outline.edge(i).to.x);
  };
  const auto high = [&](std::size_t i) {
    return std::max(outline.edge(i).from.x, outline.edge(i).to.x);
  };
  std::vector<std::size_t> order(outline.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return low(a) < low(b) || (low(a) == low(b) && a < b);
  });
  std::optional<std::pair<std::size_t, std::size_t>> first;
  for (std::size_t a = 0; a < order.size(); ++a) {
    const double end = high(order[a]);
    for (std::size_t b = a + 1; b < order.size() && low(order[b]) <= end; ++b) {
      const std::pair<std::size_t, std::size_t> edges = std::minmax(order[a], order[b]);
      if (first && *first < edges) continue;
      if (meet_wrongly(outline, edges.first, edges.second)) first = edges;
    }
  }
  if (!first) return std::nullopt;
  return crossing_error(outline, first->first, first->second);
}

}  // namespace

// NOLINTNEXTLINE(performance-unnecessary-value-param): a sink to its callers
Expected<Polygon, Error> Polygon::make(std::vector<Point> corners) {
  if (auto fault = fault_of_numbers(corners)) return Unexpected<Error>(*std::move(fault));
  Outline outline = without_repeated(corners);
  if (auto fault = fault_of_count(outline, corners.size())) {
    return Unexpected<Error>(*std::move(fault));
  }
  if (auto fault = crossing_edges(outline)) return Unexpected<Error>(*std::move(fault));
  if (twice_signed_area(outline.corners) < 0) {
    std::reverse(outline.corners.begin() + 1, outline.corners.end());
    std::reverse(outline.numbers.begin() + 1, outline.numbers.end());
    // Rounding depends on the order, and the corners of a valid polygon must be valid in its own.
    if (auto fault = crossing_edges(outline)) return Unexpected<Error>(*std::move(fault));
  }
  if (!(twice_signed_area(outline.corners) > 0)) {
    return failure(Status::invalid_option, "the polygon has no area");
  }
  return Polygon(std::move(outline.corners));
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
