#pragma once

// Boost.Graph's A* as a planner among others: "boost-astar".

#include "wend/planner/planner_info.hpp"

namespace wend::bench {

/// It supports one goal, no terrain and no limits. It does not use connected components: if there is
/// no path, it searches everything reachable.
PlannerInfo boost_astar_planner();

}  // namespace wend::bench
