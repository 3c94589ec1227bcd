// Greedy best-first search: the smallest estimate of the rest first. J. Doran and D. Michie,
// "Experiments with the Graph Traverser Program", 1966.

#include "wend/planner/grid_planner.hpp"
#include "wend/planner/grid_priorities.hpp"
#include "wend/search/heap_frontier.hpp"
#include "wend/space/heuristic.hpp"

namespace wend {
namespace {

struct GreedyOptions {
  GridMoves moves;
  HeuristicOptions heuristic{HeuristicKind::euclidean};

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    HeuristicOptions::fields(self.heuristic, field);
  }
};

using GreedyEngine = GridEngineOf<ExactGrid, HeapFrontier<RealKey<ExactGrid::Cost>>,
                                  RealEstimate<ExactGrid>, DuplicateRule::keep_first>;

GridPlanner::Parts choose_parts(const FreeSpace& space, const GreedyOptions& options) {
  const HeuristicKind kind = resolved(options.heuristic.kind, options.moves.connectivity);
  const RealEstimate<ExactGrid> estimate(kind, options.heuristic.constant, /*g_share=*/0,
                                         /*weight=*/1);
  return {options.moves, std::make_unique<GreedyEngine>(ExactGrid(space, options.moves), estimate),
          Plan::kNoBound};
}

}  // namespace

PlannerInfo greedy_planner() {
  return {.name = "greedy",
          .summary = "Greedy best-first: the estimate of the rest alone, smallest first",
          .citation = "Doran, Michie 1966",
          .guarantee = "complete; often quick, and says nothing about the cost",
          .promise = Promise::complete,
          .plans_on_terrain = false,
          .preprocessing = Preprocessing::none,
          .can_step = true,
          .options = option_schema<GreedyOptions>(),
          .make = [](const FreeSpace& space, const OptionValues& values) {
            return make_grid_planner<GreedyOptions>(space, values, choose_parts);
          }};
}

}  // namespace wend
