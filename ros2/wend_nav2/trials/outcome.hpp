// SPDX-License-Identifier: Apache-2.0
#pragma once

// Outcome: what came of one call of a planner of Nav2: a path, or the name of Nav2's error code, and the time.

#include <functional>
#include <string>

#include <nav2_core/global_planner.hpp>

#include "wend/geometry/map_pose.hpp"

namespace wend_nav2::trials {

struct Outcome {
  nav_msgs::msg::Path path;  // empty: none
  std::string code;          // NONE, as in ComputePathToPose, or CANCELED
  std::string message;       // of the exception
  double milliseconds = 0;   // on the steady clock
};

using CancelChecker = std::function<bool()>;

/// Calls a planner as the planner server does, and maps exceptions as it does. An empty path is NO_VALID_PATH.
Outcome call(
    nav2_core::GlobalPlanner& planner, const wend::MapPose& start, const wend::MapPose& goal,
    const CancelChecker& cancelled = [] { return false; });

/// Of a path's positions, in metres.
double length_of(const nav_msgs::msg::Path& path);

}  // namespace wend_nav2::trials
