#include "wend_ros/path_message.hpp"

#include <tf2/LinearMath/Quaternion.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <cmath>

#include "wend/path/path_metrics.hpp"

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

wend::MapPose pose_from(const geometry_msgs::Pose& message) {
  const auto& turn = message.orientation;
  const bool empty = turn.x == 0 && turn.y == 0 && turn.z == 0 && turn.w == 0;
  return {message.position.x, message.position.y, empty ? 0 : tf2::getYaw(turn)};
}

bool is_finite(const geometry_msgs::Pose& pose) {
  const auto& at = pose.position;
  const auto& turn = pose.orientation;
  return std::isfinite(at.x + at.y + at.z + turn.x + turn.y + turn.z + turn.w);
}

nav_msgs::Path to_message(const wend::Path& path, const wend::Frame& frame,
                          const std::string& frame_id) {
  nav_msgs::Path message;
  message.header.frame_id = frame_id;
  for (const wend::Pose& pose : path.poses()) {
    geometry_msgs::PoseStamped& stamped = message.poses.emplace_back();
    stamped.header.frame_id = frame_id;
    stamped.pose = to_message(frame.to_metres(pose));
  }
  return message;
}

nav_msgs::Path to_message(const wend::Trajectory& trajectory, const std::string& frame_id,
                          double period) {
  nav_msgs::Path message;
  message.header.frame_id = frame_id;
  for (const wend::TrajectoryState& state : trajectory.samples(period)) {
    geometry_msgs::PoseStamped& stamped = message.poses.emplace_back();
    stamped.header.frame_id = frame_id;
    stamped.header.stamp = ros::Time(state.time);
    stamped.pose = to_message(state.pose);
  }
  return message;
}

nav_msgs::Path starting_at(ros::Time start, nav_msgs::Path trajectory) {
  trajectory.header.stamp = start;
  for (auto& stamped : trajectory.poses) {
    stamped.header.stamp = start + ros::Duration(stamped.header.stamp.toSec());
  }
  return trajectory;
}

geometry_msgs::PoseArray poses_of(const nav_msgs::Path& path) {
  geometry_msgs::PoseArray poses;
  poses.header = path.header;
  for (const auto& stamped : path.poses) poses.poses.push_back(stamped.pose);
  return poses;
}

PathMetrics metrics_message(const wend::Path& path, const wend::FreeSpace& space) {
  PathMetrics message;
  if (path.empty()) return message;
  const wend::PathMetrics metrics = wend::measure(path, space);
  const double resolution = space.map().frame().resolution;
  message.length = metrics.length * resolution;
  message.turning = metrics.turning;
  message.largest_curvature = 1 / (metrics.rounded_turning_radius * resolution);
  message.smallest_clearance = metrics.smallest_clearance * resolution;
  message.mean_clearance = metrics.mean_clearance * resolution;
  message.reversals = static_cast<std::uint32_t>(metrics.reversals);
  return message;
}

}  // namespace wend_ros
