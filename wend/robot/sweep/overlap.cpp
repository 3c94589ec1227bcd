#include "wend/robot/sweep/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <vector>

#include "wend/geometry/arc_distance.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"
#include "wend/robot/sweep/point_sweep.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

/// The distance to the nearest square of the map that is not blocked, from a point in one that is.
double distance_to_free(const FreeSpace& space, Point point,
                        const std::function<bool(Cell)>& blocks) {
  const Cell from = nearest_cell(space, point);
  const int last = std::max(space.width(), space.height());
  double least = std::numeric_limits<double>::infinity();
  for (int ring = 1; ring <= last && ring - 1 <= least; ++ring) {
    for (int y = std::max(from.y - ring, 0); y <= std::min(from.y + ring, space.height() - 1);
         ++y) {
      const int step = std::abs(y - from.y) == ring ? 1 : 2 * ring;
      for (int x = from.x - ring; x <= from.x + ring; x += step) {
        const Cell cell{x, y};
        if (x >= 0 && x < space.width() && !blocks(cell)) {
          least = std::min(least, distance(point, cell));
        }
      }
    }
  }
  return least;
}

/// The part of a polygon on one side of a line: of the points with value(point) >= 0, which is linear.
template <class Value>
std::vector<Point> clipped(std::span<const Point> corners, Value&& value) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point from = corners[i];
    const Point to = corners[(i + 1) % corners.size()];
    const double before = value(from);
    const double after = value(to);
    if (before >= 0) kept.push_back(from);
    if ((before < 0) == (after < 0)) continue;
    const double share = before / (before - after);
    kept.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
  }
  return kept;
}

double area_of(std::span<const Point> corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i];
    const Point b = corners[(i + 1) % corners.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2;
}

/// The area that a polygon shares with an upright rectangle. Relative to its corner, so that rounding stays small.
double area_within(std::span<const Point> corners, Point low, double width, double height) {
  std::vector<Point> part;
  for (const Point corner : corners) part.push_back({corner.x - low.x, corner.y - low.y});
  part = clipped(part, [](Point point) { return point.x; });
  part = clipped(part, [width](Point point) { return width - point.x; });
  part = clipped(part, [](Point point) { return point.y; });
  part = clipped(part, [height](Point point) { return height - point.y; });
  return area_of(part);
}

}  // namespace

double OverlapMeasure::depth(Point point, const Blocks& blocks) const {
  const double radius = space_.radius_in_cells();
  if (blocks(nearest_cell(space_, point))) {
    return radius + distance_to_free(space_, point, blocks);
  }
  double clearance = edge_clearance(space_, point);
  any_obstacle(space_, Box(point).grown_by(radius), [&](Cell square) {
    if (blocks(square)) clearance = std::min(clearance, distance(point, square));
    return false;
  });
  // At 0 a point touches, which it may.
  if (radius == 0 || keeps_distance(space_, clearance)) return 0;
  return std::max(radius - clearance, 0.0);
}

double OverlapMeasure::covered(const Pose& pose, const Blocks& blocks) const {
  const PlacedPolygon robot(*space_.outline(), pose);
  double area = 0;
  any_obstacle(space_, robot.box(), [&](Cell square) {
    if (blocks(square) && robot.overlaps(square)) {
      area += area_within(robot.corners(),
                          {static_cast<double>(square.x), static_cast<double>(square.y)}, 1, 1);
    }
    return false;
  });
  if (space_.outside() == OutsidePolicy::free) return area;
  const double inside = area_within(robot.corners(), {0, 0}, space_.width(), space_.height());
  return area + std::max(space_.outline()->area() - inside, 0.0);
}

Overlap OverlapMeasure::at(const Pose& pose) const {
  constexpr double kAnything = std::numeric_limits<double>::infinity();
  if (!(distance_inside(space_, pose.point()) >= -kPointTolerance)) return {kAnything, kAnything};
  if (disc_ ? disc_fits_along(space_, Line{pose.point(), pose.point()}) : space_.fits(pose)) {
    return {};
  }
  const auto measured = [&](const Blocks& blocks) {
    return disc_ ? depth(pose.point(), blocks) : covered(pose, blocks);
  };
  const BitGrid& blocked = space_.obstacles().blocked();
  Overlap overlap;
  // What fits() refuses overlaps, by however little.
  overlap.all = std::max(measured([&](Cell cell) { return blocked[cell]; }),
                         std::numeric_limits<double>::min());
  overlap.obstacles = overlap.all;
  if (!space_.map().zones().empty()) {
    overlap.obstacles =
        measured([&](Cell cell) { return blocked[cell] && space_.map().zone(cell) == nullptr; });
  }
  return overlap;
}

}  // namespace wend
