#include "wend/geometry/line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wend/geometry/arc_distance.hpp"

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
  const std::array<Point, 4> corners{{{square.x + 0.0, square.y + 0.0},
                                      {square.x + 1.0, square.y + 0.0},
                                      {square.x + 0.0, square.y + 1.0},
                                      {square.x + 1.0, square.y + 1.0}}};
  const bool apart = std::max(line.from.x, line.to.x) < square.x ||
                     std::min(line.from.x, line.to.x) > square.x + 1 ||
                     std::max(line.from.y, line.to.y) < square.y ||
                     std::min(line.from.y, line.to.y) > square.y + 1;
  double least_side = side_of(line, corners[0]);
  double greatest_side = least_side;
  double least = squared_distance(line, corners[0]);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double side = side_of(line, corners[i]);
    least_side = std::min(least_side, side);
    greatest_side = std::max(greatest_side, side);
    least = std::min(least, squared_distance(line, corners[i]));
  }
  // Neither an axis nor the line itself separates them.
  if (!apart && least_side <= 0 && greatest_side >= 0) return 0;
  return std::min({std::sqrt(least), distance(line.from, square), distance(line.to, square)});
}

}  // namespace wend
