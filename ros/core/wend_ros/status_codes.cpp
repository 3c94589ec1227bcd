#include "wend_ros/status_codes.hpp"

namespace wend_ros {

StatusCode code_of(wend::Status status) {
  using wend::Status;
  switch (status) {
    case Status::found:
      return StatusCode::found;
    case Status::start_outside:
      return StatusCode::start_outside;
    case Status::goal_outside:
      return StatusCode::goal_outside;
    case Status::start_blocked:
      return StatusCode::start_blocked;
    case Status::goal_blocked:
      return StatusCode::goal_blocked;
    case Status::unreachable:
      return StatusCode::no_valid_path;
    case Status::step_limit:
    case Status::expansion_limit:
    case Status::time_limit:
      return StatusCode::timeout;
    case Status::memory_limit:
      return StatusCode::memory_limit;
    case Status::cancelled:
      return StatusCode::cancelled;
    case Status::unsupported_map:
      return StatusCode::unsupported_map;
    case Status::unsupported_query:
      return StatusCode::unsupported_query;
    case Status::invalid_option:
    case Status::invalid_file:
      return StatusCode::invalid_planner;
    case Status::invalid_map:
      return StatusCode::no_map;
    case Status::index_missing:
      return StatusCode::index_missing;
    case Status::index_mismatch:
      return StatusCode::index_mismatch;
  }
  return StatusCode::unknown_error;
}

std::string_view to_string(StatusCode code) {
  switch (code) {
    case StatusCode::found:
      return "found";
    case StatusCode::unknown_error:
      return "unknown_error";
    case StatusCode::invalid_planner:
      return "invalid_planner";
    case StatusCode::tf_error:
      return "tf_error";
    case StatusCode::start_outside:
      return "start_outside";
    case StatusCode::goal_outside:
      return "goal_outside";
    case StatusCode::start_blocked:
      return "start_blocked";
    case StatusCode::goal_blocked:
      return "goal_blocked";
    case StatusCode::timeout:
      return "timeout";
    case StatusCode::no_valid_path:
      return "no_valid_path";
    case StatusCode::no_map:
      return "no_map";
    case StatusCode::cancelled:
      return "cancelled";
    case StatusCode::memory_limit:
      return "memory_limit";
    case StatusCode::unsupported_map:
      return "unsupported_map";
    case StatusCode::unsupported_query:
      return "unsupported_query";
    case StatusCode::index_missing:
      return "index_missing";
    case StatusCode::index_mismatch:
      return "index_mismatch";
    case StatusCode::invalid_request:
      return "invalid_request";
  }
  return "unknown_error";
}

}  // namespace wend_ros
