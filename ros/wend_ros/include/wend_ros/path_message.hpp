#pragma once

// Paths as messages, in the map's frame.

#include <geometry_msgs/PoseArray.h>
#include <nav_msgs/Path.h>
#include <wend_ros/PathMetrics.h>

#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/control/route.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/path/path.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/robot/free_space.hpp"
#include "wend_ros/given_path.hpp"
#include "wend_ros/pose_message.hpp"

namespace wend_ros {

/// Of any two stamps; ros::Duration throws if they are 68 years apart, as wrong ones are.
double seconds_between(ros::Time from, ros::Time to);

/// A pose for each cell, waypoint or pose, heading along the path. An empty path stays empty.
nav_msgs::Path to_message(const wend::Path& path, const wend::Frame& frame,
                          const std::string& frame_id);

/// The same with more poses on the arcs of a path of poses, see wend::dense_poses().
nav_msgs::Path way_message(const wend::Path& path, const wend::Frame& frame,
                           const std::string& frame_id);

/// A pose every `period` seconds, and the last one. The stamps of the poses count from 0, when the robot
/// starts.
nav_msgs::Path to_message(const wend::Trajectory& trajectory, const std::string& frame_id,
                          double period);

/// The same with the stamps of a robot that starts at that time.
nav_msgs::Path starting_at(ros::Time start, nav_msgs::Path trajectory);

/// The path with a turn in place at its end, to a heading in the message's frame. An empty one stays empty.
nav_msgs::Path ending_with(double heading, nav_msgs::Path path);

/// What given_path.hpp says of the same path.
wend::Expected<wend::Trajectory, wend::Error> trajectory_from(const nav_msgs::Path& message);
wend::Expected<wend::Route, wend::Error> route_through(const nav_msgs::Path& message);
wend::Expected<wend::Route, wend::Error> route_from(const nav_msgs::Path& message);

geometry_msgs::PoseArray poses_of(const nav_msgs::Path& path);

PathMetrics metrics_message(const wend::Path& path, const wend::FreeSpace& space);

}  // namespace wend_ros
