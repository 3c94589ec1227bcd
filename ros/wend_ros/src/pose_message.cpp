#include "wend_ros/pose_message.hpp"

#include <tf2/LinearMath/Quaternion.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

namespace wend_ros {

geometry_msgs::Pose to_message(const wend::MapPose& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  tf2::Quaternion turn;
  turn.setRPY(0, 0, pose.heading);
  message.orientation = tf2::toMsg(turn);
  return message;
}

Orientation orientation_of(const geometry_msgs::Quaternion& turn) {
  return {turn.x, turn.y, turn.z, turn.w};
}

GivenPose given_pose(const geometry_msgs::Pose& message) {
  const geometry_msgs::Point& at = message.position;
  return {at.x, at.y, at.z, orientation_of(message.orientation)};
}

wend::Expected<wend::MapPose, std::string> pose_from(const geometry_msgs::Pose& message) {
  return pose_from(given_pose(message));
}

wend::Expected<wend::MapPose, std::string> moved_pose_from(const geometry_msgs::Pose& message) {
  return moved_pose_from(given_pose(message));
}

wend::Expected<wend::MapPose, std::string> pose_from(const geometry_msgs::Transform& transform) {
  const geometry_msgs::Vector3& at = transform.translation;
  return moved_pose_from(GivenPose{at.x, at.y, at.z, orientation_of(transform.rotation)});
}

}  // namespace wend_ros
