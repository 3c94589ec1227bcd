#pragma once

// Lengths for a scenario whose own do not hold, because it was made for another robot.

#include <vector>

#include "wend/io/query/scenario.hpp"
#include "wend/map/free_space.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

/// Sets the lengths of queries to what Dijkstra's algorithm finds: infinite where there is no path.
void set_lengths(std::vector<ScenarioQuery>& queries, const FreeSpace& space, GridMoves moves);

}  // namespace wend::cli
