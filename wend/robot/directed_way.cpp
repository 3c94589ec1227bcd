#include "wend/robot/directed_way.hpp"

#include "wend/robot/near_map.hpp"

namespace wend {
namespace {

bool is_forbidden(const FreeSpace& space, const WayPart& part) {
  return space.directions()->factor(part.cell, part.heading) == DirectionMap::kForbidden;
}

template <class Way>
bool may_go(const FreeSpace& space, const Way& way) {
  if (space.directions() == nullptr || !near_map(space, way)) return true;
  return for_each_part(space, way, [&](const WayPart& part) { return !is_forbidden(space, part); });
}

}  // namespace

bool may_step(const FreeSpace& space, Cell from, Cell to) {
  const DirectionMap* const directions = space.directions();
  if (directions == nullptr) return true;
  const Direction direction = direction_of({to.x - from.x, to.y - from.y});
  return directions->factor(from, direction) != DirectionMap::kForbidden &&
         directions->factor(to, direction) != DirectionMap::kForbidden;
}

double directed_factor(const FreeSpace& space, const Segment& segment) {
  if (space.directions() == nullptr || !near_map(space, segment)) return 1;
  double sum = 0;
  double length = 0;
  const bool may = for_each_part(space, segment, [&](const WayPart& part) {
    const std::uint32_t factor = space.directions()->factor(part.cell, part.heading);
    sum += part.length * factor;
    length += part.length;
    return factor != DirectionMap::kForbidden;
  });
  if (!may) return std::numeric_limits<double>::infinity();
  return length == 0 ? 1 : sum / (length * DirectionMap::kOne);
}

bool may_go_along(const FreeSpace& space, const Line& line) { return may_go(space, line); }
bool may_go_along(const FreeSpace& space, const Arc& arc) { return may_go(space, arc); }
bool may_go_along(const FreeSpace& space, const Segment& segment) { return may_go(space, segment); }

bool AgainstArrows::take(const FreeSpace& space, const WayPart& part) {
  constexpr double kMost = 0.125;  // cells
  length_ = is_forbidden(space, part) ? length_ + part.length : 0;
  return length_ < kMost;
}

bool AgainstArrows::go_along(const FreeSpace& space, const Line& line) {
  if (space.directions() == nullptr || !near_map(space, line)) return true;
  return for_each_part(space, line, [&](const WayPart& part) { return take(space, part); });
}

bool AgainstArrows::go_along(const FreeSpace& space, const Arc& arc) {
  if (space.directions() == nullptr || !near_map(space, arc)) return true;
  return for_each_part(space, arc, [&](const WayPart& part) { return take(space, part); });
}

bool AgainstArrows::go_along(const FreeSpace& space, const Segment& segment) {
  if (space.directions() == nullptr || !near_map(space, segment)) return true;
  return for_each_part(space, segment, [&](const WayPart& part) { return take(space, part); });
}

}  // namespace wend
