#pragma once

// Status codes: the numbers by which ROS clients know how a query ended. Those that Nav2's action
// ComputePathToPose has are the same here; the others follow from 250 on.
//
//   code  name                from
//      0  found               Status::found
//    200  unknown_error       anything else
//    201  invalid_planner     invalid_option: no such planner, or options out of range;
//                            invalid_file: a file that they name is invalid
//    202  tf_error            a pose's frame cannot be taken to the map's
//    203  start_outside       204  goal_outside
//    205  start_blocked       206  goal_blocked
//    207  timeout             time_limit, expansion_limit, step_limit
//    208  no_valid_path       unreachable
//    250  no_map              no map has come yet, or it is invalid (invalid_map)
//    251  cancelled           252  memory_limit
//    253  unsupported_map     254  unsupported_query
//    255  index_missing       256  index_mismatch
//    257  invalid_request     a number that is no number, no goal

#include <cstdint>
#include <string_view>

#include "wend/base/status.hpp"

namespace wend_ros {

enum class StatusCode : std::uint16_t {
  found = 0,
  unknown_error = 200,
  invalid_planner = 201,
  tf_error = 202,
  start_outside = 203,
  goal_outside = 204,
  start_blocked = 205,
  goal_blocked = 206,
  timeout = 207,
  no_valid_path = 208,
  no_map = 250,
  cancelled = 251,
  memory_limit = 252,
  unsupported_map = 253,
  unsupported_query = 254,
  index_missing = 255,
  index_mismatch = 256,
  invalid_request = 257,
};

StatusCode code_of(wend::Status status);

/// The name as it stands in the enum.
std::string_view to_string(StatusCode code);

}  // namespace wend_ros
