#include "wend/geometry/line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wend {
namespace {

double squared(Point point) { return point.x * point.x + point.y * point.y; }

/// Positive to the left of the line.
double side_of(const Line& line, Point point) {
  return (line.to.x - line.from.x) * (point.y - line.from.y) -
         (line.to.y - line.from.y) * (point.x - line.from.x);
}

double squared_distance(const Line& line, Point point) {
  const Point step{line.to.x - line.from.x, line.to.y - line.from.y};
  const Point offset{point.x - line.from.x, point.y - line.from.y};
  const double along = step.x * offset.x + step.y * offset.y;
  const double length = squared(step);
  const double share = along <= 0 ? 0 : along >= length ? 1 : along / length;
  return squared({offset.x - share * step.x, offset.y - share * step.y});
}

}  // namespace

double distance(const Line& line, Point point) { return std::sqrt(squared_distance(line, point)); }

double distance(const Line& line, Cell square) {
  const double left = square.x;
  const double right = square.x + 1.0;
  const double low = square.y;
  const double high = square.y + 1.0;
  const std::array<Point, 4> corners{{{left, low}, {right, low}, {left, high}, {right, high}}};
  double least_side = side_of(line, corners[0]);
  double greatest_side = least_side;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double side = side_of(line, corners[i]);
    least_side = std::min(least_side, side);
    greatest_side = std::max(greatest_side, side);
  }
  const bool apart =
      std::max(line.from.x, line.to.x) < left || std::min(line.from.x, line.to.x) > right ||
      std::max(line.from.y, line.to.y) < low || std::min(line.from.y, line.to.y) > high;
  // Neither an axis nor the line itself separates them.
  if (!apart && least_side <= 0 && greatest_side >= 0) return 0;
  // The nearest pair of points includes an end of the line or a corner of the square.
  const auto to_square = [&](Point point) {
    return squared({std::max({left - point.x, point.x - right, 0.0}),
                    std::max({low - point.y, point.y - high, 0.0})});
  };
  double least = std::min(to_square(line.from), to_square(line.to));
  for (const Point corner : corners) least = std::min(least, squared_distance(line, corner));
  return std::sqrt(least);
}

}  // namespace wend
