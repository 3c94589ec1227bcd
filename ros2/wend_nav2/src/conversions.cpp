// SPDX-License-Identifier: Apache-2.0
#include "conversions.hpp"

#include <cmath>
#include <span>

#include "wend_nav2/robot_shape.hpp"

namespace wend_nav2 {

wend::MapPose pose_from(const geometry_msgs::msg::Pose& message) {
  const auto& turn = message.orientation;
  const double heading =
      std::atan2(2 * (turn.w * turn.z + turn.x * turn.y),
                 turn.w * turn.w + turn.x * turn.x - turn.y * turn.y - turn.z * turn.z);
  return {message.position.x, message.position.y, heading};
}

geometry_msgs::msg::Pose to_message(const wend::MapPose& pose) {
  geometry_msgs::msg::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation.z = std::sin(pose.heading / 2);
  message.orientation.w = std::cos(pose.heading / 2);
  return message;
}

nav_msgs::msg::Path to_message(const std::vector<wend::MapPose>& poses,
                               const std_msgs::msg::Header& header) {
  nav_msgs::msg::Path message;
  message.header = header;
  message.poses.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    message.poses[i].header = header;
    message.poses[i].pose = to_message(poses[i]);
  }
  return message;
}

wend::Expected<wend::Footprint, wend::Error> footprint_from(
    const std::vector<geometry_msgs::msg::Point>& corners) {
  std::vector<wend::MapPoint> points;
  for (const auto& corner : corners) points.push_back({corner.x, corner.y});
  return footprint_from(std::span<const wend::MapPoint>(points));
}

void read(nav2_costmap_2d::Costmap2D& costmap, const std::string& frame_id, CostmapCopy& copy) {
  const std::lock_guard lock(*costmap.getMutex());
  const CostmapLayout layout{.width = static_cast<int>(costmap.getSizeInCellsX()),
                             .height = static_cast<int>(costmap.getSizeInCellsY()),
                             .resolution = costmap.getResolution(),
                             .origin = {costmap.getOriginX(), costmap.getOriginY()},
                             .frame_id = frame_id};
  copy.read(layout, {costmap.getCharMap(), layout.size()});
}

}  // namespace wend_nav2
