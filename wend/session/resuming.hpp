#pragma once

// Which planner answers again for a robot that drives while its map changes.

#include "wend/base/compiler.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// `replanner` with the moves of a planner from cell to cell whose every path is optimal, as long as that planner
/// itself can plan in this space, needs no index, does not resume and finds one path only; else the planner itself.
/// So the path is of the same kind and costs the same.
WEND_API PlannerSpec resuming(const PlannerSpec& spec, const FreeSpace& space);

}  // namespace wend
