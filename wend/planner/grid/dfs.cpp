// Depth-first search: the cell reached last first. C. P. Trémaux, 1882 (in E. Lucas, "Récréations
// mathématiques").

#include "wend/planner/grid/grid_options.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/planner/grid/ordered_engine.hpp"

namespace wend {
namespace {

using DfsEngine = GridEngineOf<ExactGrid, LifoFrontier, ByArrival, DuplicateRule::keep_first>;

GridPlanner::Parts dfs_parts(const FreeSpace& space, const DfsOptions& options) {
  const GridMoves& moves = options.moves;
  if (options.neighbours != NeighbourOrder::any) {
    const SearchOrder order{options.neighbours, Ties::newest};
    return {moves, make_first_way_engine(space, {.moves = moves, .order = order}), Plan::kNoBound};
  }
  return {moves, std::make_unique<DfsEngine>(ExactGrid(space, moves), ByArrival()), Plan::kNoBound};
}

}  // namespace

PlannerInfo dfs_planner() {
  return grid_planner<DfsOptions>(
      {.name = "dfs",
       .summary = "Depth-first search: the newest cell first",
       .idea =
           "Its frontier is a stack: it follows one path until it is stuck, then returns to the "
           "newest open cell.",
       .citation = "Trémaux 1882",
       .guarantee_text = "complete; the path is rarely short",
       .time = "O(n) in the n cells expanded",
       .memory = "16 bytes per cell, 4 per open cell",
       .bytes_per_cell = 16,
       .when = "For teaching, and for mazes with only one path. Not for robots: in open space its "
               "paths wander over the whole map.",
       .guarantee = Guarantee::complete},
      dfs_parts);
}

}  // namespace wend
