#pragma once

// What people ask for with --start, --goal and --goal-tolerance, as a request to a session.

#include <string>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/parser.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/plan_request.hpp"

namespace wend::cli {

/// --start, --goal and --goal-tolerance
struct EndArguments {
  std::string start;
  std::vector<std::string> goals;  // one or more
  std::string tolerance = {};      // of all goals; empty: none
};

/// --goal-tolerance. It is read when the map is known, by typed_request().
void add_goal_tolerance(Parser& app, std::string& tolerance);

/// The request for a planner, in grid coordinates, worded as its ends were typed: cells, or poses where the planner's
/// states have headings. Throws InputError for text that is not a start, goal or tolerance of it.
PlanRequest typed_request(const PlannerSpec& planner, const FreeSpace& space,
                          const Coordinates& coordinates, const EndArguments& ends);

}  // namespace wend::cli
