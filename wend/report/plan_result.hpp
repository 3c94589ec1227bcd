#pragma once

// PlanResult: one query's outcome, found or not, with all that a report says about it.

#include <cstdint>
#include <optional>
#include <string>

#include "wend/base/status.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/report/path_report.hpp"
#include "wend/report/work_times.hpp"

namespace wend {

struct PlanResult {
  std::string planner;
  Status status = Status::found;
  Plan plan;  // of a failure: its metrics
  WorkTimes times{};
  std::string reason;  // of a failure, for people
  Motion motion = Motion::cells;
  std::uint64_t states = 0;  // Planner::state_count()
  // What became of the path, where it was smoothed or the like.
  std::optional<RefinedPath> refined{};
  int unit = 0;  // Planner::corner_unit(): the turning radius of a car in cells
};

}  // namespace wend
