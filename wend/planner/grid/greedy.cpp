// Greedy best-first search: the smallest estimate of the rest first. J. Doran and D. Michie,
// "Experiments with the Graph Traverser Program", 1966.

#include "wend/planner/grid/grid_options.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/planner/grid/ordered_engine.hpp"

namespace wend {
namespace {

using GreedyEngine = GridEngineOf<ExactGrid, HeapFrontier<RealKey<ExactGrid::Cost>>,
                                  RealEstimate<ExactGrid>, DuplicateRule::keep_first>;

GridPlanner::Parts greedy_parts(const FreeSpace& space, const GreedyOptions& options) {
  const HeuristicKind kind = resolved(options.heuristic.kind, options.moves.connectivity);
  if (options.order.chosen()) {
    return {options.moves,
            make_first_way_engine(space, {.moves = options.moves,
                                          .order = options.order,
                                          .heuristic = kind,
                                          .constant = options.heuristic.constant,
                                          .weight = 1}),
            Plan::kNoBound};
  }
  const RealEstimate<ExactGrid> estimate(kind, options.heuristic.constant, /*g_share=*/0,
                                         /*weight=*/1);
  return {options.moves, std::make_unique<GreedyEngine>(ExactGrid(space, options.moves), estimate),
          Plan::kNoBound};
}

}  // namespace

PlannerInfo greedy_planner() {
  return grid_planner<GreedyOptions>(
      {.name = "greedy",
       .summary = "Greedy best-first: lowest estimate first",
       .idea = "It ignores the cost so far. In front of a wall it explores the whole area before "
               "it goes around.",
       .citation = "Doran, Michie 1966",
       .guarantee_text = "complete; often fast, with no bound on the cost",
       .time = "O(n log n) in the n cells expanded",
       .memory = "16 bytes per cell, 24 per frontier entry",
       .bytes_per_cell = 16,
       .when = "Where time matters more than cost. Smooth its paths, or use astar with a weight, "
               "which has a bound.",
       .guarantee = Guarantee::complete},
      greedy_parts);
}

}  // namespace wend
