// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/failure.hpp"

namespace wend_nav2 {

FailureKind kind_of(wend::Status status) {
  using wend::Status;
  switch (status) {
    case Status::start_outside:
      return FailureKind::start_outside;
    case Status::goal_outside:
      return FailureKind::goal_outside;
    case Status::start_blocked:
      return FailureKind::start_occupied;
    case Status::goal_blocked:
      return FailureKind::goal_occupied;
    case Status::unreachable:
      return FailureKind::no_valid_path;
    case Status::step_limit:
    case Status::expansion_limit:
    case Status::time_limit:
      return FailureKind::timed_out;
    case Status::cancelled:
      return FailureKind::cancelled;
    case Status::invalid_option:
    case Status::invalid_file:
    case Status::index_missing:
    case Status::index_mismatch:
    case Status::unsupported_map:
    case Status::unsupported_query:
      return FailureKind::invalid_planner;
    case Status::found:
    case Status::memory_limit:
    case Status::invalid_map:
      break;
  }
  return FailureKind::other;
}

std::string_view to_string(FailureKind kind) {
  switch (kind) {
    case FailureKind::invalid_planner:
      return "invalid_planner";
    case FailureKind::tf_error:
      return "tf_error";
    case FailureKind::start_outside:
      return "start_outside";
    case FailureKind::goal_outside:
      return "goal_outside";
    case FailureKind::start_occupied:
      return "start_occupied";
    case FailureKind::goal_occupied:
      return "goal_occupied";
    case FailureKind::timed_out:
      return "timed_out";
    case FailureKind::no_valid_path:
      return "no_valid_path";
    case FailureKind::cancelled:
      return "cancelled";
    case FailureKind::other:
      break;
  }
  return "other";
}

Failure failure_of(const wend::Error& error) { return {kind_of(error.status), error.message}; }

}  // namespace wend_nav2
