// SPDX-License-Identifier: Apache-2.0
#pragma once

// RobotShape: the robot as a costmap knows it, and what becomes of it for a rule about obstacles. Knows no ROS.

#include <optional>
#include <span>
#include <string_view>

#include "wend/base/error.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/map/occupancy.hpp"
#include "wend/robot/footprint.hpp"
#include "wend/robot/free_space.hpp"
#include "wend_nav2/planner_settings.hpp"

namespace wend_nav2 {

struct RobotShape {
  wend::Footprint footprint = {};  // metres; a disc if the costmap has a radius
  bool inflated = true;            // does the costmap mark 253 where the robot's centre may not be?
};

/// The footprint with these corners, in the robot's frame. Corners that are as good as a circle around it, as Nav2
/// publishes for a radius, are a disc. The robot's origin may lie outside. Fails as wend::Polygon::make() does.
wend::Expected<wend::Footprint, wend::Error> footprint_from(
    std::span<const wend::MapPoint> corners);

/// The same of a text: corners as Nav2 writes them, "[[0.4, 0.2], ...]", or any other that wend::parse_footprint()
/// reads.
wend::Expected<wend::Footprint, wend::Error> footprint_from(std::string_view text);

/// What `automatic` stands for; another rule stands for itself.
ObstacleRule rule_for(ObstacleRule rule);

/// How costs are read, and the robot to plan with, for a rule that is not `automatic`.
wend::CostmapScale scale_for(ObstacleRule rule, double cost_factor);
wend::FreeSpaceOptions robot_for(ObstacleRule rule, const RobotShape& robot, bool allow_unknown);

}  // namespace wend_nav2
