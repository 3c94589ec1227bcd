// ALT: A* with landmarks and the triangle inequality. A. Goldberg and C. Harrelson, "Computing the Shortest Path: A*
// Search Meets Graph Theory", 2005.

#include "wend/planner/costs/leap_engine.hpp"
#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/grid/grid_options.hpp"

namespace wend {
namespace {

GridPlanner::Parts alt_parts(const FreeSpace& space, const AltOptions& options,
                             DeadlineCheck& stop) {
  const HeuristicKind kind = resolved(HeuristicKind::automatic, options.moves.connectivity);
  const BestFirst parts{options.moves, kind, 0, 1};
  if (!can_leap(space, parts)) return best_first_parts(space, parts);
  return leap_parts(space, parts, static_cast<unsigned>(options.landmarks), stop);
}

}  // namespace

PlannerInfo alt_planner() {
  return grid_planner<AltOptions>(
      {.name = "alt",
       .summary = "ALT: A* guided by exact costs of landmarks",
       .idea = "The costs from some far cells, the landmarks, to all cells are computed when the "
               "planner is made. "
               "By the triangle inequality they are lower bounds of the cost to the goal that know "
               "of walls "
               "and costs.",
       .citation = "Goldberg, Harrelson 2005",
       .guarantee_text = "optimal; on terrain at most 1.5e-6 of the cost more",
       .time = "as astar with leaps, in fewer cells; making it, one search of the whole map for "
               "each landmark",
       .memory = "45 bytes per cell with 8 landmarks: 4 for each, and 13; twice 13 if sums of "
                 "costs outgrow 32 bits",
       .bytes_per_cell = 45,
       .when = "For many queries on one map with costs. An edit that makes cells free or cheaper "
               "ends the use of the "
               "landmarks. Where a disc may cut corners, and for several goals or a goal with a "
               "tolerance, "
               "it searches as astar.",
       .guarantee = Guarantee::optimal,
       .preprocessing = Preprocessing::quick,
       .capabilities = {.jumps = true, .terrain = true, .resumes = true}},
      alt_parts);
}

}  // namespace wend
