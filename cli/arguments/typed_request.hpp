#pragma once

// What people ask for with --start, --goal, --goal-tolerance, --via and --closed, as a request to a session.

#include <string>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/parser.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/plan_request.hpp"

namespace wend::cli {

/// --start, --goal, --goal-tolerance, --via and --closed
struct EndArguments {
  std::string start;
  std::vector<std::string> goals;      // one or more; none of a closed path
  std::string tolerance = {};          // of all goals; empty: none
  std::vector<std::string> vias = {};  // on the way, in order
  bool closed = false;                 // leads back to the start
};

/// --via and --closed
void add_vias(Parser& app, EndArguments& ends);

/// Throws InputError where the ends of a query do not belong together.
void check_vias(const EndArguments& ends);

/// --goal-tolerance. It is read when the map is known, by typed_request().
void add_goal_tolerance(Parser& app, std::string& tolerance);

/// The request for a planner, in grid coordinates, worded as its ends were typed: cells, or poses where the planner's
/// states have headings. Throws InputError for text that is not a start, goal, via or tolerance of it.
PlanRequest typed_request(const PlannerSpec& planner, const FreeSpace& space,
                          const Coordinates& coordinates, const EndArguments& ends);

}  // namespace wend::cli
