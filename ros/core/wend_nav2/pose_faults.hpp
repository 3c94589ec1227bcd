// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is wrong with poses that come from outside: what is not finite, or absurdly far, never reaches a planner, a
// smoother or a controller. Knows no ROS.

#include <optional>
#include <span>
#include <string>

#include "wend/geometry/map_pose.hpp"

namespace wend_nav2 {

/// "(3, 1.25)", rounded to centimetres.
std::string place_of(const wend::MapPose& pose);

/// "contains NaN or infinity", "is farther than 1e+08 m from the origin of its frame" (wend::Route::kFarthest). Nothing if the pose is one.
std::optional<std::string> fault_of(const wend::MapPose& pose);

/// The same of the first pose of a path that is none: "pose 20 of the path, (nan, 1), contains NaN or infinity". The
/// first pose has the number 0.
std::optional<std::string> fault_of(std::span<const wend::MapPose> path);

}  // namespace wend_nav2
