// SPDX-License-Identifier: Apache-2.0
#pragma once

// Poses and paths as messages of ROS, and back. Knows no Nav2: wend_ros uses it, too.

#include <string>
#include <vector>

#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/transform.hpp>
#include <nav_msgs/msg/path.hpp>

#include "wend/base/expected.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend_nav2/orientation.hpp"

namespace wend_nav2 {

/// Fails, with a sentence that begins "its orientation", as heading_of() does.
wend::Expected<wend::MapPose, std::string> pose_from(const geometry_msgs::msg::Pose& message,
                                                     Tilt tilt);
geometry_msgs::msg::Pose to_message(const wend::MapPose& pose);

/// The pose of the child frame in its parent's; tf has looked at its rotation.
wend::MapPose pose_from(const geometry_msgs::msg::Transform& transform);

/// The poses of a path, which may begin on a slope. Fails as pose_from() does: "pose 20 of the path: its orientation ...".
wend::Expected<std::vector<wend::MapPose>, std::string> poses_from(const nav_msgs::msg::Path& path);

/// A path whose poses have this header.
nav_msgs::msg::Path to_message(const std::vector<wend::MapPose>& poses,
                               const std_msgs::msg::Header& header);

}  // namespace wend_nav2
