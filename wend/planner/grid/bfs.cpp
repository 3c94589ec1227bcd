// Breadth-first search: cells in the order in which they are reached. E. F. Moore, "The Shortest
// Path Through a Maze", 1959.

#include <numbers>

#include "wend/planner/grid/grid_options.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/planner/grid/ordered_engine.hpp"

namespace wend {
namespace {

using BfsEngine = GridEngineOf<ExactGrid, FifoFrontier, ByFewestSteps, DuplicateRule::keep_first>;

/// The fewest steps are the cheapest path where all steps cost the same, and within sqrt(2) of it
/// where some are diagonal.
double bound(const FreeSpace& space, const GridMoves& moves) {
  if (!space.uniform_terrain()) return Plan::kNoBound;
  return moves.connectivity == Connectivity::four ? 1 : std::numbers::sqrt2;
}

GridPlanner::Parts bfs_parts(const FreeSpace& space, const BfsOptions& options) {
  const GridMoves& moves = options.moves;
  if (options.neighbours != NeighbourOrder::any) {
    const SearchOrder order{options.neighbours, Ties::oldest};
    return {moves,
            make_first_way_engine(space, {.moves = moves, .order = order, .fewest_steps = true}),
            bound(space, moves)};
  }
  return {moves, std::make_unique<BfsEngine>(ExactGrid(space, moves), ByFewestSteps()),
          bound(space, moves)};
}

}  // namespace

PlannerInfo bfs_planner() {
  return grid_planner<BfsOptions>(
      {.name = "bfs",
       .summary = "Breadth-first search: the oldest cell first",
       .idea = "Its frontier is a queue, so the first path to the goal has the fewest steps; among "
               "such "
               "paths it keeps a shortest one.",
       .citation = "Moore 1959",
       .guarantee_text = "fewest steps; on uniform terrain optimal on 4 neighbours, and at most "
                         "sqrt(2) times the optimum on 8",
       .time = "O(n) in the n cells expanded",
       .memory = "16 bytes per cell, 4 per open cell",
       .bytes_per_cell = 16,
       .when = "Where the number of moves matters, or on 4 neighbours and uniform terrain. On 8 "
               "neighbours a diagonal step counts as one step.",
       .guarantee = Guarantee::fewest_steps},
      bfs_parts);
}

}  // namespace wend
