#pragma once

// RunParts: what a session gives a search run.

#include <cstdint>
#include <memory>

#include "wend/base/deadline.hpp"
#include "wend/base/limits.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/explainer.hpp"
#include "wend/session/kept_field.hpp"
#include "wend/session/kept_plan.hpp"
#include "wend/session/plan_request.hpp"
#include "wend/session/warm_planners.hpp"

namespace wend {

// What is nearly ready when the time ends is finished, so that the next call has it.
inline constexpr double kSecondsToFinish = 0.01;

struct RunParts {
  FreeSpace space;
  std::uint64_t version;  // of the space
  WarmPlanner planner;
  PlannerSpec spec;  // of the planner
  PlanRequest request;
  Deadline deadline;  // of the whole call
  Hints hints;
  Clock clock;                       // null: the steady clock
  std::shared_ptr<KeptField> field;  // never null
  std::shared_ptr<KeptPlan> kept;    // of a robot that replans; null: it does not
};

}  // namespace wend
