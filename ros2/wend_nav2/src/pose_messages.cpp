// SPDX-License-Identifier: Apache-2.0
#include "pose_messages.hpp"

#include <cmath>

namespace wend_nav2 {
namespace {

double heading_of(const geometry_msgs::msg::Quaternion& turn) {
  return std::atan2(2 * (turn.w * turn.z + turn.x * turn.y),
                    turn.w * turn.w + turn.x * turn.x - turn.y * turn.y - turn.z * turn.z);
}

}  // namespace

wend::MapPose pose_from(const geometry_msgs::msg::Pose& message) {
  return {message.position.x, message.position.y, heading_of(message.orientation)};
}

wend::MapPose pose_from(const geometry_msgs::msg::Transform& transform) {
  return {transform.translation.x, transform.translation.y, heading_of(transform.rotation)};
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
