// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a costmap of Nav2 has, as wend's types.

#include <memory>
#include <string>
#include <vector>

#include <geometry_msgs/msg/point.hpp>
#include <nav2_costmap_2d/costmap_2d.hpp>

#include "nav2_types.hpp"
#include "wend/base/expected.hpp"
#include "wend/robot/footprint.hpp"
#include "wend_nav2/costmap_copy.hpp"
#include "wend_nav2/robot_shape.hpp"

namespace wend_nav2 {

wend::Expected<wend::Footprint, wend::Error> footprint_from(
    const std::vector<geometry_msgs::msg::Point>& corners);

/// The costmap's robot, padding included. Fails if the footprint is not a polygon.
wend::Expected<RobotShape, wend::Error> robot_of(
    std::shared_ptr<nav2_costmap_2d::Costmap2DROS>& costmap);

/// Reads the costs, with the costmap's lock.
void read(nav2_costmap_2d::Costmap2D& costmap, const std::string& frame_id, CostmapCopy& copy);

}  // namespace wend_nav2
