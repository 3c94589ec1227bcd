#include "wend_ros/path_message.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "wend/control/given_route.hpp"
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

/// The poses of a path as `read` reads each of them, or which one is wrong; `name`: of the path.
template <class Read>
wend::Expected<std::vector<wend::MapPose>, wend::Error> poses_from(const nav_msgs::Path& message,
                                                                   const std::string& name,
                                                                   const Read& read) {
  std::vector<wend::MapPose> poses;
  poses.reserve(message.poses.size());
  for (const auto& stamped : message.poses) {
    const std::string& frame_id = stamped.header.frame_id;
    if (!frame_id.empty() && frame_id != message.header.frame_id) {
      return wend::failure(wend::Status::unsupported_query,
                           "a pose of " + name + " is in the frame '" + frame_id + "', not '" +
                               message.header.frame_id + "'");
    }
    const auto pose = read(stamped.pose);
    if (!pose) {
      const std::string number = std::to_string(poses.size());
      return wend::failure(wend::Status::unsupported_query,
                           "pose " + number + " of " + name + " " + pose.error());
    }
    poses.push_back(*pose);
  }
  return poses;
}

wend::Unexpected<wend::Error> no_poses() {
  return wend::failure(wend::Status::unsupported_query, "the path has no poses");
}

}  // namespace

double seconds_between(ros::Time from, ros::Time to) {
  return static_cast<double>(to.sec) - static_cast<double>(from.sec) +
         1e-9 * (static_cast<double>(to.nsec) - static_cast<double>(from.nsec));
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
  auto poses = poses_from(message, "the trajectory",
                          [](const geometry_msgs::Pose& pose) { return pose_from(pose); });
  if (!poses) return wend::Unexpected<wend::Error>(std::move(poses.error()));
  std::vector<wend::TimedPose> timed;
  timed.reserve(poses->size());
  for (std::size_t i = 0; i < poses->size(); ++i) {
    const ros::Time& stamp = message.poses[i].header.stamp;
    timed.push_back({seconds_between(message.poses.front().header.stamp, stamp), (*poses)[i]});
  }
  return wend::Trajectory::through(timed);
}

wend::Expected<wend::Route, wend::Error> route_through(const nav_msgs::Path& message) {
  const auto poses = poses_from(message, "the path",
                                [](const geometry_msgs::Pose& pose) { return pose_from(pose); });
  if (!poses) return wend::Unexpected<wend::Error>(poses.error());
  if (poses->empty()) return no_poses();
  std::vector<wend::Pose> places;
  for (const wend::MapPose& pose : *poses) places.push_back({pose.x, pose.y, pose.heading});
  return wend::Route(wend::Path::through(std::move(places)), wend::Frame{});
}

wend::Expected<wend::Route, wend::Error> route_from(const nav_msgs::Path& message) {
  const bool has_headings = std::any_of(
      message.poses.begin(), message.poses.end(), [](const geometry_msgs::PoseStamped& stamped) {
        return !is_unset(orientation_of(stamped.pose.orientation));
      });
  const auto poses = poses_from(message, "the path", [&](geometry_msgs::Pose pose) {
    if (!has_headings) pose.orientation.w = 1;
    return pose_from(pose);
  });
  if (!poses) return wend::Unexpected<wend::Error>(poses.error());
  if (has_headings || poses->empty()) return wend::given_route(*poses);
  std::vector<wend::Point> points;
  for (const wend::MapPose& pose : *poses) points.push_back({pose.x, pose.y});
  return wend::Route(wend::Path::along(std::move(points)), wend::Frame{});
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
