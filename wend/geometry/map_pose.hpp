#pragma once

// MapPoint and MapPose: a position, and a position with a heading, in map coordinates: metres and
// radians in the map's frame. Point and Pose (pose.hpp) are in grid coordinates. These are types
// of their own, so that metres in place of cells do not compile. Frame (frame.hpp) converts.

#include <cmath>

#include "wend/geometry/trigonometry.hpp"

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

/// Euclidean distance in metres.
inline double distance(MapPoint a, MapPoint b) { return hypotenuse(a.x - b.x, a.y - b.y); }

}  // namespace wend
