// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pieces of a path of poses from any planner: stretches that are driven in one direction, cut where the path turns
// by more than a right angle or in place. Knows no ROS.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/geometry/map_pose.hpp"

namespace wend_nav2 {

/// The places of the poses where pieces begin, and that of the last pose. At least two poses.
std::vector<std::size_t> cuts_of(std::span<const wend::MapPose> path);

/// Is a piece of a path whose headings count (wend::headings_count()) driven in reverse? Most of its way decides.
bool in_reverse(std::span<const wend::MapPose> piece);

}  // namespace wend_nav2
