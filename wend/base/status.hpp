#pragma once

// The outcome of a query: found, or the reason for the failure. Every front end maps this
// enum once (exit codes, ROS results, Python exceptions).

#include <optional>
#include <string_view>

#include "wend/base/compiler.hpp"

namespace wend {

/// How a query or an operation ended.
enum class Status {
  found,              // there is a path
  start_outside,      // the start lies outside the map
  goal_outside,       // the goal lies outside the map
  start_blocked,      // the robot cannot stand on the start
  goal_blocked,       // the robot cannot stand on the goal
  unreachable,        // start and goal are both free, and no path joins them
  step_limit,         // a walk used up its steps (RandomWalkOptions::max_steps)
  expansion_limit,    // Limits::expansions was reached
  time_limit,         // Limits::seconds passed
  memory_limit,       // the system had no memory left for the search
  cancelled,          // Limits::cancel was set
  unsupported_map,    // this planner cannot plan on such a map (terrain, size)
  unsupported_query,  // this planner cannot answer such a query (no goal, too many goals)
  invalid_option,     // an option is unknown or out of range
  invalid_map,        // the parts of a map do not fit together, or a value is out of range
  invalid_file,       // a file cannot be read or written, or its content is invalid
  index_missing,      // the planner needs an index, and none was given
  index_mismatch,     // the index is damaged or belongs to another map
};

/// The name in the enum: "found", "start_outside", ...
WEND_API std::string_view to_string(Status status);

/// One sentence for people, without the details of a query: "the start lies outside the map".
WEND_API std::string_view describe(Status status);

/// Inverse of to_string; nothing for a name that is not in the enum.
WEND_API std::optional<Status> status_from_string(std::string_view name);

}  // namespace wend
