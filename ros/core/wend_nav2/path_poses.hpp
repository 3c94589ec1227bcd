// SPDX-License-Identifier: Apache-2.0
#pragma once

// The poses of a path as Nav2 wants them: dense, in metres, from the start to the goal. Knows no ROS.

#include <vector>

#include "wend/geometry/map_pose.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend_nav2 {

/// Poses of a path that is not empty, in metres, neighbours at most `spacing` (> 0) metres of the way apart. Poses
/// of cells and waypoints face along the way; the last one as the one before.
std::vector<wend::MapPose> poses_along(const wend::Path& path, const wend::Frame& frame,
                                       double spacing);

/// A path of cells or waypoints that begins and ends where it was asked to, not in the middle of these cells, if its
/// ends lie in their cells and the robot may go there; else the same end as before.
wend::Path with_exact_ends(const wend::Path& path, const wend::FreeSpace& space,
                           wend::Adjacency adjacency, const wend::MapPose& start,
                           const wend::MapPose& goal);

}  // namespace wend_nav2
