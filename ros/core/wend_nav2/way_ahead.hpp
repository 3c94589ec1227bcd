// SPDX-License-Identifier: Apache-2.0
#pragma once

// Does a route lead into an obstacle soon, or past obstacles? Knows no ROS.

#include "wend/control/route.hpp"
#include "wend/robot/free_space.hpp"
#include "wend_nav2/frame_change.hpp"

namespace wend_nav2 {

/// Does the robot's inscribed disc, less half a cell, pass along a leg from `along` on, for `length` metres or to the
/// leg's end? The costmap of the space ends where it ends: what lies beyond counts as free. O(length).
bool is_free_ahead(const wend::RouteLeg& leg, double along, double length,
                   const FrameChange& to_costmap, const wend::FreeSpace& space);

}  // namespace wend_nav2
