// SPDX-License-Identifier: Apache-2.0
#pragma once

// Map messages for OccupancyCosts, the status codes of answers, and what rviz shows of them.

#include <map_msgs/msg/occupancy_grid_update.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/path.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend_nav2/failure.hpp"
#include "wend_ros/occupancy.hpp"
#include "wend_ros/status_codes.hpp"

namespace wend_ros {

/// Fails with invalid_map, and the reason, if the origin's orientation is none, or is tilted.
wend::Expected<OccupancyLayout, wend::Error> layout_of(const nav_msgs::msg::OccupancyGrid& map);

/// A view of the message.
OccupancyUpdate update_of(const map_msgs::msg::OccupancyGridUpdate& update);

StatusCode code_of(wend_nav2::FailureKind kind);

/// Of a path's positions, in metres.
double length_of(const nav_msgs::msg::Path& path);

/// The path as a line, its start and goal as arrows. An empty path: what deletes them.
visualization_msgs::msg::MarkerArray markers_of(const nav_msgs::msg::Path& path);

}  // namespace wend_ros
