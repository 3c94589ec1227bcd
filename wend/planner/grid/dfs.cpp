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
       .summary = "Depth-first search: expands the cell that was reached last",
       .idea = "Open cells are kept on a stack and the one that was reached last is expanded "
               "first: the search follows one path until it is stuck, then returns to the most "
               "recent open cell.",
       .citation = "Trémaux 1882",
       .guarantee_text = "complete; the path is rarely short",
       .time = "O(n) in the n cells expanded",
       .memory = "16 bytes per cell and 4 per open cell",
       .bytes_per_cell = 16,
       .when = "To see the effect of a stack in place of a queue, and to find a path through a "
               "maze that has only one. In open space its paths wander over the whole map: do not "
               "execute them on a robot.",
       .guarantee = Guarantee::complete},
      choose_parts);
}

}  // namespace wend
