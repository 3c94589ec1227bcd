#include "wend/geometry/car_move.hpp"

#include <cmath>
#include <limits>

namespace wend {

std::optional<CornerPose> nearest_corner_pose(const Pose& pose, int unit) {
  const double x = unit * std::round(pose.x / unit);
  const double y = unit * std::round(pose.y / unit);
  constexpr double kMost = std::numeric_limits<int>::max();
  if (!(std::abs(x) <= kMost && std::abs(y) <= kMost) || !std::isfinite(pose.heading)) {
    return std::nullopt;
  }
  return CornerPose{{static_cast<int>(x), static_cast<int>(y)}, nearest_heading(pose.heading)};
}

}  // namespace wend
