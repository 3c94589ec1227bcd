#include "wend/robot/near_map.hpp"

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr double kMostTurn = 4 * kPi;

/// An arc of two full turns around the largest circle near the map is not longer.
double longest_near(const FreeSpace& space) {
  return 4 * (space.width() + space.height() + 4 * kFarthestOffMap);
}

}  // namespace

bool near_map(const FreeSpace& space, const Arc& arc) {
  return near_map(space, arc.from) && std::abs(arc.length) <= longest_near(space) &&
         std::abs(arc.turn()) <= kMostTurn;
}

bool near_map(const FreeSpace& space, const Segment& segment) {
  return near_map(space, segment.from) && std::abs(segment.length) <= longest_near(space) &&
         std::abs(segment.turn) <= kMostTurn && std::abs(segment.course) <= kPi;
}

bool near_map(const FreeSpace& space, const TurnInPlace& turn) {
  return near_map(space, turn.from) && std::abs(turn.angle) <= kMostTurn;
}

}  // namespace wend
