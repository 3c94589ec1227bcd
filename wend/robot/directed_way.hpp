#pragma once

// What directions (wend/map/direction_map.hpp) say of the ways of a robot's base point.
//
//   if (!wend::may_go_along(space, line)) return report("against an arrow");
//
// A line is judged in each cell that it crosses, an arc at points a sixteenth of a cell apart. Parts of less than
// 1e-6 cell are not judged; a line along a border lies in the cell of the greater coordinate. Planners do not go against an
// arrow at all; who checks a path that may have been rounded takes AgainstArrows, which overlooks 1/8 cell.
//
// O(cells of the way).

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/map/direction_map.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// What a step in this direction costs per unit of length in a cell of the map that it leaves or enters, as a number of
/// CostMap steps; DirectionMap::kForbidden.
inline std::uint32_t directed_steps_of(const FreeSpace& space, Cell cell, Direction direction) {
  const std::uint32_t steps = space.costs().steps(cell);
  const DirectionMap* const directions = space.directions();
  return directions == nullptr ? steps : directed_steps(steps, directions->factor(cell, direction));
}

/// The multiplier of a cell of the map for a heading: `multiplier` times what the direction says, rounded; infinite where
/// it is forbidden.
inline double directed_multiplier(const FreeSpace& space, Cell cell, double multiplier,
                                  double heading) {
  const DirectionMap* const directions = space.directions();
  if (directions == nullptr || directions->none_at(cell)) return multiplier;
  const std::uint32_t factor = directions->factor(cell, heading);
  if (factor == DirectionMap::kForbidden) return std::numeric_limits<double>::infinity();
  const auto steps = static_cast<std::uint32_t>(std::lround(multiplier * CostMap::kOne));
  return static_cast<double>(directed_steps(steps, factor)) / CostMap::kOne;
}

/// May the step from a cell to a neighbour be made, as far as directions go? Both are on the map.
bool may_step(const FreeSpace& space, Cell from, Cell to);

/// A part of a way that lies in one cell of the map.
struct WayPart {
  Cell cell;       // where
  double length;   // in cells
  double heading;  // of the move, in radians
};

/// The cell of the map that a point on a way lies in: on a border that of the greater coordinate, on the map's edge the one
/// inside; nothing off the map.
inline std::optional<Cell> judging_cell(const FreeSpace& space, Point point) {
  constexpr double kSliver = 1e-6;  // cells
  for (const double aside : {kSliver, -kSliver}) {
    const Cell cell = cell_at(Point{point.x + aside, point.y + aside});
    if (space.contains(cell)) return cell;
  }
  return std::nullopt;
}

/// Calls `visit(part)` for the parts of a line, in order, until it returns false; parts off the map are left out. False if
/// it did. The line is near_map().
template <class Visit>
bool for_each_part(const FreeSpace& space, const Line& line, Visit&& visit) {
  constexpr double kSliver = 1e-6;  // cells
  const double length = line.length();
  if (!(length > kSliver)) return true;
  const double heading = line.heading();
  // Where the line next crosses an upright and a flat border, as a share of it.
  const auto first = [](double at, double way) {
    const double border = way > 0 ? std::floor(at) + 1 : std::ceil(at) - 1;
    return way == 0 ? std::numeric_limits<double>::infinity() : (border - at) / way;
  };
  const double dx = line.to.x - line.from.x;
  const double dy = line.to.y - line.from.y;
  const double upright = first(line.from.x, dx);
  const double flat = first(line.from.y, dy);
  double share = 0;
  for (int i = 0, j = 0; share < 1;) {
    const double x = dx == 0 ? upright : upright + i / std::abs(dx);
    const double y = dy == 0 ? flat : flat + j / std::abs(dy);
    const double next = std::min(1.0, std::min(x, y));
    if (x <= next) ++i;
    if (y <= next) ++j;
    const double part = (next - share) * length;
    const auto cell = judging_cell(space, line.at((share + next) / 2));
    if (part > kSliver && cell && !visit(WayPart{*cell, part, heading})) return false;
    share = next;
  }
  return true;
}
/// The same for an arc, near_map() too: in equal parts of at most a sixteenth of a cell.
template <class Visit>
bool for_each_part(const FreeSpace& space, const Arc& arc, Visit&& visit) {
  constexpr double kPart = 1.0 / 16;
  if (arc.curvature == 0) {
    return for_each_part(space, Line{arc.from.point(), end_of(arc).point()}, visit);
  }
  const double length = std::abs(arc.length);
  const int parts = 1 + static_cast<int>(length / kPart);
  for (int i = 0; i < parts; ++i) {
    const Pose pose = pose_on(arc, arc.length * (i + 0.5) / parts);
    const auto cell = judging_cell(space, pose.point());
    if (!cell) continue;
    const double heading = arc.length < 0 ? normalized_angle(pose.heading + kPi) : pose.heading;
    if (!visit(WayPart{*cell, length / parts, heading})) return false;
  }
  return true;
}
/// The same for a segment.
template <class Visit>
bool for_each_part(const FreeSpace& space, const Segment& segment, Visit&& visit) {
  return segment.length == 0 || for_each_part(space, way_of_base(segment), visit);
}

/// The mean factor of the directions along a way, at least 1; infinite where one forbids it. 1 for a way off the map.
double directed_factor(const FreeSpace& space, const Segment& segment);

/// May the robot move along a way, as far as directions go? True off the map, and for a turn in place.
bool may_go_along(const FreeSpace& space, const Line& line);
/// The same for an arc.
bool may_go_along(const FreeSpace& space, const Arc& arc);
/// The same for a segment.
bool may_go_along(const FreeSpace& space, const Segment& segment);

/// Where a path, way by way, leads against arrows for so long that it is no rounding.
class AgainstArrows {
 public:
  /// Goes along the next way. False if it leads against arrows that forbid it.
  bool go_along(const FreeSpace& space, const Line& line);
  /// The same for an arc.
  bool go_along(const FreeSpace& space, const Arc& arc);
  /// The same for a segment.
  bool go_along(const FreeSpace& space, const Segment& segment);

 private:
  bool take(const FreeSpace& space, const WayPart& part);

  double length_ = 0;  // that it has led against arrows
};

}  // namespace wend
