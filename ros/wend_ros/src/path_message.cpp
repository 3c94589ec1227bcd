#include "wend_ros/path_message.hpp"

#include <string>
#include <utility>
#include <vector>

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

/// What a message says.
GivenPath given(const nav_msgs::Path& message) {
  GivenPath path{message.header.frame_id, {}};
  path.poses.reserve(message.poses.size());
  for (const auto& stamped : message.poses) {
    const ros::Time& stamp = stamped.header.stamp;
    path.poses.push_back(
        {stamped.header.frame_id, {stamp.sec, stamp.nsec}, given_pose(stamped.pose)});
  }
  return path;
}

}  // namespace

double seconds_between(ros::Time from, ros::Time to) {
  return seconds_between(GivenTime{from.sec, from.nsec}, GivenTime{to.sec, to.nsec});
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

nav_msgs::Path ending_with(double heading, nav_msgs::Path path) {
  if (path.poses.empty()) return path;
  geometry_msgs::Pose& last = path.poses.back().pose;
  last.orientation = to_message(wend::MapPose{0, 0, heading}).orientation;
  return path;
}

wend::Expected<wend::Trajectory, wend::Error> trajectory_from(const nav_msgs::Path& message) {
  return trajectory_from(given(message));
}

wend::Expected<wend::Route, wend::Error> route_through(const nav_msgs::Path& message) {
  return route_through(given(message));
}

wend::Expected<wend::Route, wend::Error> route_from(const nav_msgs::Path& message) {
  return route_from(given(message));
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
  for (const wend::Metric& metric : metrics_of(metrics)) {
    Metric& added = message.all.emplace_back();
    added.name = metric.name;
    added.unit = metric_unit_name(metric.unit);
    added.value = metric.in_metres(resolution);
  }
  return message;
}

}  // namespace wend_ros
