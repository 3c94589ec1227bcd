// Depth-first search: the cell reached last first. C. P. Trémaux, 1882 (in E. Lucas, "Récréations
// mathématiques").

#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/search/frontiers.hpp"

namespace wend {
namespace {

using DfsEngine = GridEngineOf<ExactGrid, LifoFrontier, ByArrival, DuplicateRule::keep_first>;

GridPlanner::Parts choose_parts(const FreeSpace& space, const GridMoves& moves) {
  return {moves, std::make_unique<DfsEngine>(ExactGrid(space, moves), ByArrival()), Plan::kNoBound};
}

}  // namespace

PlannerInfo dfs_planner() {
  return grid_planner<GridMoves>(
      {.name = "dfs",
       .summary = "Depth-first: the cell that was reached last",
       .idea = "Cells wait on a stack and the one that was reached last is expanded first: the "
               "search runs on until it is stuck, then goes back to the last cell left open.",
       .citation = "Trémaux 1882",
       .guarantee_text = "complete; the path is rarely short",
       .time = "O(n) in the n cells expanded",
       .memory = "16 bytes a cell and 4 an open cell",
       .bytes_per_cell = 16,
       .when = "To see what a stack does in place of a queue, and to find some way through a "
               "maze, where there is only one. In open space its paths wander through "
               "everything: do not drive them.",
       .guarantee = Guarantee::complete},
      choose_parts);
}

}  // namespace wend
