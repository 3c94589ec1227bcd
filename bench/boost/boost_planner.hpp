#pragma once

// Boost.Graph's A* as a planner among others: "boost-astar".

#include "wend/planner/planner_info.hpp"

namespace wend::bench {

/// It takes one goal, no terrain and no limits, and knows nothing of connected components: where there
/// is no path it searches all it can reach.
PlannerInfo boost_astar_planner();

}  // namespace wend::bench
