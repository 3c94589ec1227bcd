// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pieces of a path of poses from any planner: stretches that are driven in one direction, cut where the path turns
// by more than a right angle or in place. Knows no ROS.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/control/route.hpp"
#include "wend/geometry/map_pose.hpp"

namespace wend_nav2 {

/// The places of the poses where pieces begin, and that of the last pose. At least two poses.
std::vector<std::size_t> cuts_of(std::span<const wend::MapPose> path);

/// Do the poses of a path face anywhere? Not if all but the last face along +x, as planners without headings give them.
bool has_headings(std::span<const wend::MapPose> path);

/// Is a piece of a path with headings driven in reverse? Most of its way decides.
bool in_reverse(std::span<const wend::MapPose> piece);

/// The route along a path (not empty) in its own frame: a leg for each piece that has a length; it ends with the
/// heading of the last pose.
wend::Route route_along(std::span<const wend::MapPose> path);

}  // namespace wend_nav2
