#include "wend/geometry/frame.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

constexpr double kBorderMetres = 1e-9;
constexpr double kMostBorder = 1e-3;  // cells
constexpr double kLargestCell = 1e9;

}  // namespace

MapPoint Frame::to_metres(Point grid) const {
  const double along = resolution * grid.x;
  const double across = resolution * grid.y;
  if (origin.heading == 0) return {origin.x + along, origin.y + across};
  const auto [sine, cosine] = sine_and_cosine(origin.heading);
  return {origin.x + cosine * along - sine * across, origin.y + sine * along + cosine * across};
}

Point Frame::to_grid(MapPoint metres) const {
  const double along = metres.x - origin.x;
  const double across = metres.y - origin.y;
  if (origin.heading == 0) return {along / resolution, across / resolution};
  const auto [sine, cosine] = sine_and_cosine(origin.heading);
  return {(cosine * along + sine * across) / resolution,
          (cosine * across - sine * along) / resolution};
}

MapPose Frame::to_metres(Pose grid) const {
  const MapPoint point = to_metres(grid.point());
  return {point.x, point.y, normalized_angle(grid.heading + origin.heading)};
}

Pose Frame::to_grid(MapPose metres) const {
  const Point point = to_grid(metres.point());
  return {point.x, point.y, normalized_angle(metres.heading - origin.heading)};
}

std::optional<Cell> Frame::cell_at(MapPoint metres) const {
  const Point grid = to_grid(metres);
  const double border = std::min(kBorderMetres / resolution, kMostBorder);
  const double x = std::floor(grid.x + border);
  const double y = std::floor(grid.y + border);
  // Written so that it also rejects numbers that are not finite.
  if (!(std::abs(x) <= kLargestCell && std::abs(y) <= kLargestCell)) return std::nullopt;
  return Cell{static_cast<int>(x), static_cast<int>(y)};
}

}  // namespace wend
