#pragma once

// PlanResult: one query's outcome, found or not, with all that a report says about it.

#include <cstdint>
#include <string>

#include "wend/base/status.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

struct PlanResult {
  std::string planner;
  Status status = Status::found;
  Plan plan;           // of a failure: its metrics
  double seconds = 0;  // that plan() took
  std::string reason;  // of a failure, for people
  Motion motion = Motion::cells;
  std::uint64_t states = 0;  // Planner::state_count()
};

}  // namespace wend
