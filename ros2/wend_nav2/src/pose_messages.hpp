// SPDX-License-Identifier: Apache-2.0
#pragma once

// Poses and paths as messages of ROS, and back. Knows no Nav2: wend_ros uses it, too.

#include <vector>

#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/transform.hpp>
#include <nav_msgs/msg/path.hpp>

#include "wend/geometry/map_pose.hpp"

namespace wend_nav2 {

/// The heading is that of the rotation about z; of a rotation of length 0 it is 0.
wend::MapPose pose_from(const geometry_msgs::msg::Pose& message);
geometry_msgs::msg::Pose to_message(const wend::MapPose& pose);

/// The pose of the child frame in its parent's.
wend::MapPose pose_from(const geometry_msgs::msg::Transform& transform);

/// A path whose poses have this header.
nav_msgs::msg::Path to_message(const std::vector<wend::MapPose>& poses,
                               const std_msgs::msg::Header& header);

}  // namespace wend_nav2
