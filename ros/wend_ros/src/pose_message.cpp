#include "wend_ros/pose_message.hpp"

#include <tf2/LinearMath/Quaternion.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <cmath>
#include <optional>

#include "wend/control/route.hpp"

namespace wend_ros {
namespace {

/// What is wrong with a position, if anything is.
template <class Position>
std::optional<std::string> fault_of(const Position& at) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z)) {
    return "contains NaN or infinity";
  }
  if (wend::Route::can_hold(wend::MapPoint{at.x, at.y})) return std::nullopt;
  return "is farther than 1e8 m from the origin";
}

template <class Position>
wend::Expected<wend::MapPose, std::string> pose_at(
    const Position& at, const wend::Expected<double, std::string>& heading) {
  if (auto fault = fault_of(at)) return wend::Unexpected<std::string>(*std::move(fault));
  if (!heading) return wend::Unexpected<std::string>(heading.error());
  return wend::MapPose{at.x, at.y, *heading};
}

}  // namespace

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

wend::Expected<wend::MapPose, std::string> pose_from(const geometry_msgs::Pose& message) {
  return pose_at(message.position, heading_of(orientation_of(message.orientation)));
}

wend::Expected<wend::MapPose, std::string> moved_pose_from(const geometry_msgs::Pose& message) {
  return pose_at(message.position, heading_of_frame(orientation_of(message.orientation)));
}

wend::Expected<wend::MapPose, std::string> pose_from(const geometry_msgs::Transform& transform) {
  return pose_at(transform.translation, heading_of_frame(orientation_of(transform.rotation)));
}

}  // namespace wend_ros
