#pragma once

// CornerPose: where a car on a lattice of grid corners stands and faces.
//
//   const wend::CornerPose place{{1, 0}, wend::Heading::plus_x};
//   const wend::Pose pose = wend::pose_of(place);  // x 1, y 0, heading 0

#include <cmath>
#include <limits>
#include <optional>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// The place of a car: a corner (the point with these grid coordinates) and a heading.
struct CornerPose {
  Cell vertex;                        // a corner of cells
  Heading heading = Heading::plus_x;  // where the car faces

  friend constexpr bool operator==(const CornerPose&, const CornerPose&) = default;
};

/// Converts to a pose in grid coordinates.
inline Pose pose_of(const CornerPose& place) {
  return {static_cast<double>(place.vertex.x), static_cast<double>(place.vertex.y),
          radians_of(place.heading)};
}

/// The lattice vertex and the heading nearest to a finite pose in grid coordinates. It may lie outside
/// any map. Nothing if the coordinates are too large for a vertex.
inline std::optional<CornerPose> nearest_corner_pose(const Pose& pose, int unit = 1) {
  const double x = unit * std::round(pose.x / unit);
  const double y = unit * std::round(pose.y / unit);
  constexpr double kMost = std::numeric_limits<int>::max();
  if (!(std::abs(x) <= kMost && std::abs(y) <= kMost) || !std::isfinite(pose.heading)) {
    return std::nullopt;
  }
  return CornerPose{{static_cast<int>(x), static_cast<int>(y)}, nearest_heading(pose.heading)};
}

}  // namespace wend
