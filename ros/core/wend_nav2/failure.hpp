// SPDX-License-Identifier: Apache-2.0
#pragma once

// Failure: why there is no path or no smoothed path, as one of the kinds of errors that Nav2 has. Knows no ROS.
//
//   kind              exception of nav2_core      from
//   invalid_planner   InvalidPlanner              invalid_option, invalid_file, index_missing, index_mismatch,
//                                                 unsupported_map, unsupported_query
//   tf_error          PlannerTFError              a pose in another frame than the costmap's
//   start_outside     StartOutsideMapBounds       start_outside
//   goal_outside      GoalOutsideMapBounds        goal_outside
//   start_occupied    StartOccupied               start_blocked
//   goal_occupied     GoalOccupied                goal_blocked
//   timed_out         PlannerTimedOut             time_limit, expansion_limit, step_limit
//   no_valid_path     NoValidPathCouldBeFound     unreachable
//   cancelled         PlannerCancelled            cancelled
//   other             PlannerException            invalid_map, memory_limit
//
// A search that was ended by a limit has not shown that there is no path, and a start that is free but closed in is
// not occupied: the two are never confused.

#include <string>
#include <string_view>

#include "wend/base/error.hpp"
#include "wend/base/status.hpp"

namespace wend_nav2 {

/// What Nav2 distinguishes.
enum class FailureKind {
  invalid_planner,
  tf_error,
  start_outside,
  goal_outside,
  start_occupied,
  goal_occupied,
  timed_out,
  no_valid_path,
  cancelled,
  other,
};

/// The kind of a status that is not `found`.
FailureKind kind_of(wend::Status status);

/// The name in the enum.
std::string_view to_string(FailureKind kind);

struct Failure {
  FailureKind kind = FailureKind::other;
  std::string message = {};  // a sentence that says where and why

  friend bool operator==(const Failure&, const Failure&) = default;
};

/// The failure of an error.
Failure failure_of(const wend::Error& error);

}  // namespace wend_nav2
