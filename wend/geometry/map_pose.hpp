#pragma once

// MapPoint and MapPose: a position, and a position with a heading, in map coordinates: metres and
// radians in the map's frame. Point and Pose (pose.hpp) are in grid coordinates. These are types
// of their own, so that metres in place of cells do not compile.

#include <cmath>

#include "wend/geometry/frame.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// A position in the map's frame.
struct MapPoint {
  double x = 0;  // metres
  double y = 0;  // metres

  friend constexpr bool operator==(const MapPoint&, const MapPoint&) = default;
};

/// A position and a heading in the map's frame.
struct MapPose {
  double x = 0;        // metres
  double y = 0;        // metres
  double heading = 0;  // radians, counter-clockwise from the frame's +x

  /// The position alone.
  constexpr MapPoint point() const { return {x, y}; }

  friend constexpr bool operator==(const MapPose&, const MapPose&) = default;
};

/// Converts to grid coordinates, as Frame::to_grid() does.
inline Point in_grid(const Frame& frame, MapPoint point) {
  return frame.to_grid(Point{point.x, point.y});
}
/// The same for poses: the heading turns by the frame's yaw.
inline Pose in_grid(const Frame& frame, const MapPose& pose) {
  return frame.to_grid(Pose{pose.x, pose.y, pose.heading});
}

/// Converts to map coordinates, as Frame::to_metres() does.
inline MapPoint in_metres(const Frame& frame, Point point) {
  const Point metres = frame.to_metres(point);
  return {metres.x, metres.y};
}
/// The same for poses.
inline MapPose in_metres(const Frame& frame, const Pose& pose) {
  const Pose metres = frame.to_metres(pose);
  return {metres.x, metres.y, metres.heading};
}

/// Euclidean distance in metres.
inline double distance(MapPoint a, MapPoint b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace wend
