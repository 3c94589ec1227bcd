// SPDX-License-Identifier: Apache-2.0
#include "pose_messages.hpp"

#include <cmath>
#include <cstddef>

namespace wend_nav2 {

wend::Expected<wend::MapPose, std::string> pose_from(const geometry_msgs::msg::Pose& message,
                                                     Tilt tilt) {
  const auto& turn = message.orientation;
  const auto heading = heading_of({turn.x, turn.y, turn.z, turn.w}, tilt);
  if (!heading) return wend::Unexpected<std::string>(heading.error());
  return wend::MapPose{message.position.x, message.position.y, *heading};
}

wend::MapPose pose_from(const geometry_msgs::msg::Transform& transform) {
  const auto& turn = transform.rotation;
  return {transform.translation.x, transform.translation.y,
          std::atan2(2 * (turn.w * turn.z + turn.x * turn.y),
                     turn.w * turn.w + turn.x * turn.x - turn.y * turn.y - turn.z * turn.z)};
}

wend::Expected<std::vector<wend::MapPose>, std::string> poses_from(
    const nav_msgs::msg::Path& path) {
  std::vector<wend::MapPose> poses;
  poses.reserve(path.poses.size());
  for (const auto& stamped : path.poses) {
    const auto pose = pose_from(stamped.pose, Tilt::slope);
    if (!pose) {
      return wend::Unexpected<std::string>("pose " + std::to_string(poses.size()) +
                                           " of the path: " + pose.error());
    }
    poses.push_back(*pose);
  }
  return poses;
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

}  // namespace wend_nav2
