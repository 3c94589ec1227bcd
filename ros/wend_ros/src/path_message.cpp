#include "wend_ros/path_message.hpp"

#include <tf2/LinearMath/Quaternion.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <cmath>

#include "wend/path/dense_poses.hpp"
#include "wend/path/path_metrics.hpp"

namespace wend_ros {
namespace {

nav_msgs::Path message_of(const std::vector<wend::Pose>& poses, const wend::Frame& frame,
                          const std::string& frame_id) {
  nav_msgs::Path message;
  message.header.frame_id = frame_id;
  for (const wend::Pose& pose : poses) {
    geometry_msgs::PoseStamped& stamped = message.poses.emplace_back();
    stamped.header.frame_id = frame_id;
    stamped.pose = to_message(frame.to_metres(pose));
  }
  return message;
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

wend::MapPose pose_from(const geometry_msgs::Pose& message) {
  const auto& turn = message.orientation;
  const bool empty = turn.x == 0 && turn.y == 0 && turn.z == 0 && turn.w == 0;
  return {message.position.x, message.position.y, empty ? 0 : tf2::getYaw(turn)};
}

double seconds_between(ros::Time from, ros::Time to) {
  return static_cast<double>(to.sec) - static_cast<double>(from.sec) +
         1e-9 * (static_cast<double>(to.nsec) - static_cast<double>(from.nsec));
}

bool is_finite(const geometry_msgs::Pose& pose) {
  const auto& at = pose.position;
  const auto& turn = pose.orientation;
  return std::isfinite(at.x + at.y + at.z + turn.x + turn.y + turn.z + turn.w);
}

nav_msgs::Path to_message(const wend::Path& path, const wend::Frame& frame,
                          const std::string& frame_id) {
  return message_of(path.poses(), frame, frame_id);
}

nav_msgs::Path way_message(const wend::Path& path, const wend::Frame& frame,
                           const std::string& frame_id) {
  return message_of(wend::dense_poses(path), frame, frame_id);
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

wend::Expected<wend::Trajectory, wend::Error> trajectory_from(const nav_msgs::Path& message) {
  std::vector<wend::TimedPose> poses;
  poses.reserve(message.poses.size());
  for (const auto& stamped : message.poses) {
    const std::string& frame_id = stamped.header.frame_id;
    if (!frame_id.empty() && frame_id != message.header.frame_id) {
      return wend::failure(wend::Status::unsupported_query,
                           "a pose of the trajectory is in the frame '" + frame_id + "', not '" +
                               message.header.frame_id + "'");
    }
    poses.push_back({seconds_between(message.poses.front().header.stamp, stamped.header.stamp),
                     pose_from(stamped.pose)});
  }
  return wend::Trajectory::through(poses);
}

wend::Path path_through(const nav_msgs::Path& message) {
  std::vector<wend::Pose> poses;
  for (const auto& stamped : message.poses) {
    const wend::MapPose pose = pose_from(stamped.pose);
    poses.push_back({pose.x, pose.y, pose.heading});
  }
  return wend::Path::through(poses);
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
  const auto measured = wend::measure(path, space);
  if (!measured) return message;
  const wend::PathMetrics& metrics = *measured;
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
