// SPDX-License-Identifier: Apache-2.0
#pragma once

// Messages of ROS to wend's types and back.

#include <mutex>
#include <string>
#include <vector>

#include <geometry_msgs/msg/point.hpp>
#include <geometry_msgs/msg/pose.hpp>
#include <nav2_costmap_2d/costmap_2d.hpp>
#include <nav_msgs/msg/path.hpp>

#include "wend/base/expected.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/robot/footprint.hpp"
#include "wend_nav2/costmap_copy.hpp"

namespace wend_nav2 {

/// The heading is that of the rotation about z; of a rotation of length 0 it is 0.
wend::MapPose pose_from(const geometry_msgs::msg::Pose& message);
geometry_msgs::msg::Pose to_message(const wend::MapPose& pose);

/// A path whose poses have this header.
nav_msgs::msg::Path to_message(const std::vector<wend::MapPose>& poses,
                               const std_msgs::msg::Header& header);

wend::Expected<wend::Footprint, wend::Error> footprint_from(
    const std::vector<geometry_msgs::msg::Point>& corners);

/// Reads the costs, with the costmap's lock.
void read(nav2_costmap_2d::Costmap2D& costmap, const std::string& frame_id, CostmapCopy& copy);

}  // namespace wend_nav2
