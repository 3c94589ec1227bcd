// Replanning: keeps the last path while it is the cheapest, else searches anew.

#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/incremental/incremental_options.hpp"
#include "wend/planner/incremental/replan_engine.hpp"

namespace wend {
namespace {

GridPlanner::Parts replanner_parts(const FreeSpace& space, const ReplannerOptions& options,
                                   DeadlineCheck& stop) {
  const HeuristicKind kind = resolved(HeuristicKind::automatic, options.moves.connectivity);
  return replan_parts(space, {options.moves, kind, 0, 1}, stop);
}

}  // namespace

PlannerInfo replanner_planner() {
  return grid_planner<ReplannerOptions>(
      {.name = "replanner",
       .summary = "Replanning: keeps its last path, or searches",
       .idea = "It first asks whether the rest of the last path can have become dearer, or another "
               "one cheaper. If so, it searches anew with leaps.",
       .citation = "after Stentz 1995",
       .guarantee_text = "optimal; on terrain at most 1.5e-6 of the cost more",
       .time = "O(changes + the rest of the path) if the path is kept; else as astar with leaps",
       .memory = "13 bytes per cell; twice that if sums of costs outgrow 32 bits",
       .bytes_per_cell = 13,
       .when = "For a robot that drives while its map changes: keep the planner, and tell it of "
               "edits. For single queries take astar or jps.",
       .guarantee = Guarantee::optimal,
       .capabilities = {.jumps = true, .terrain = true, .resumes = true}},
      replanner_parts);
}

}  // namespace wend
