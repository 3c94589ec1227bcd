#pragma once

// The words of failures: sentences in the units of a map, for all planners alike. An Explainer adds what would help.
//
//   const auto plan = planner->plan(query);
//   if (!plan) return report(wend::words_of(plan.error(), space));
//   // "the goal (3,1) is blocked: the cell is an obstacle"

#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/planner/failure.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/units.hpp"

namespace wend {

/// What a front end calls the options that an explanation recommends, such as "--unknown free". An
/// explanation leaves out what is empty.
struct Hints {
  std::string unknown_free = {};      // unknown cells count as free
  std::string outside_free = {};      // the robot may extend beyond the map
  std::string squeeze = {};           // diagonal moves between obstacles that touch
  std::string robot_radius = {};      // a radius follows
  std::string nearest = {};           // plans from or to the nearest free place
  std::string nearest_limit = {};     // how far an end may be moved; a length follows
  std::string escape = {};            // leads the robot out of what blocks it; a length follows
  std::string explain = {};           // shows the explanation: "`wend explain` shows where"
  std::string limit_expansions = {};  // a number follows
  std::string limit_seconds = {};     // a number follows
  std::string limit_steps = {};       // limits the steps of a walk
  std::string turning_radius = {};    // a radius follows
  std::string allow_reverse = {};     // the robot may drive in reverse
};

/// The start and the goals of a query, in words.
struct Ends {
  Place start;               // where the path begins
  std::vector<Place> goals;  // one or more

  /// One of them.
  const Place& at(EndIndex end) const { return end ? goals[*end] : start; }
};

/// Why there is no path, in one or more sentences, in the units of the space's map. Of a failure that is not about a
/// path, such as one of making a planner, its message.
WEND_API std::string words_of(const PlanFailure& failure, const FreeSpace& space,
                              const Hints& hints = {});
/// The same of a failure and the work of its search.
WEND_API std::string words_of(const Failure& failure, const SearchMetrics& metrics,
                              const FreeSpace& space, const Hints& hints = {});

}  // namespace wend
