#include "wend/robot/sweep/sweep.hpp"

namespace wend {

double distance_inside(const FreeSpace& space, Point point) {
  return std::min({point.x, space.width() - point.x, point.y, space.height() - point.y});
}

double distance_inside(const FreeSpace& space, const Line& line) {
  return std::min(distance_inside(space, line.from), distance_inside(space, line.to));
}

double distance_inside(const FreeSpace& space, const Arc& arc) {
  double least = std::min(distance_inside(space, arc.from.point()),
                          distance_inside(space, point_on(arc, arc.length)));
  if (arc.curvature == 0) return least;
  // Between its ends an arc lies farthest out where it heads along an axis.
  constexpr double kQuarter = kPi / 2;
  const double first = arc.from.heading / kQuarter;
  const double last = first + arc.turn() / kQuarter;
  const auto end = static_cast<int>(std::floor(std::max(first, last)));
  for (auto i = static_cast<int>(std::ceil(std::min(first, last))); i <= end; ++i) {
    const double along = (i * kQuarter - arc.from.heading) / arc.curvature;
    least = std::min(least, distance_inside(space, point_on(arc, along)));
  }
  return least;
}

}  // namespace wend
