#pragma once

// near_map: is a way near enough to the map to be looked at, whatever its numbers are?
//
//   if (!wend::near_map(space, point)) return report("NaN, infinite or far off the map");
//
// Sweeps and metrics ask it first, so that their time depends on the size of the map, and not on that of a
// number.

#include <cmath>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// No point lies farther from the grid's origin than this along an axis, in cells: there, numbers are exact to a
/// four-millionth of a cell.
inline constexpr double kFarthestPoint = 1 << 30;

/// No farther off the map than this, in cells, robots are looked at.
inline constexpr double kFarthestOffMap = 1000;

/// No larger than this, either sign, are headings, in radians: up to it, sines are exact to 3e-16.
inline constexpr double kLargestHeading = 1e6;

/// Is the point no farther from the origin than kFarthestPoint? False for NaN and infinity. O(1).
inline bool is_exact(Point point) {
  return std::abs(point.x) <= kFarthestPoint && std::abs(point.y) <= kFarthestPoint;
}

/// Does the point lie on the map, or no farther off it than kFarthestOffMap along either axis? False for NaN and
/// infinity. O(1).
inline bool near_map(const FreeSpace& space, Point point) {
  return point.x >= -kFarthestOffMap && point.x <= space.width() + kFarthestOffMap &&
         point.y >= -kFarthestOffMap && point.y <= space.height() + kFarthestOffMap;
}
/// The same for a pose, whose heading is at most kLargestHeading.
inline bool near_map(const FreeSpace& space, const Pose& pose) {
  return near_map(space, pose.point()) && std::abs(pose.heading) <= kLargestHeading;
}
/// Is that so at both ends of a line?
inline bool near_map(const FreeSpace& space, const Line& line) {
  return near_map(space, line.from) && near_map(space, line.to);
}
/// Does the arc begin near the map, turn by no more than two full turns, and is it no longer than such an arc near
/// the map can be?
WEND_API bool near_map(const FreeSpace& space, const Arc& arc);
/// The same for a segment.
WEND_API bool near_map(const FreeSpace& space, const Segment& segment);
/// The same for a turn in place.
WEND_API bool near_map(const FreeSpace& space, const TurnInPlace& turn);

}  // namespace wend
