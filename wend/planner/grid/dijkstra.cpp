// Dijkstra's algorithm: the cheapest g first. E. W. Dijkstra, "A Note on Two Problems in Connexion
// with Graphs", 1959.

#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/grid/grid_planner.hpp"

namespace wend {
namespace {

GridPlanner::Parts choose_parts(const FreeSpace& space, const GridMoves& moves) {
  const BestFirst parts{moves, HeuristicKind::zero, 0, 0};
  return {moves, make_best_first_engine(space, parts), parts.bound()};
}

}  // namespace

PlannerInfo dijkstra_planner() {
  return grid_planner<GridMoves>(
      {.name = "dijkstra",
       .summary = "Dijkstra: what the path costs so far, cheapest first",
       .idea = "Cells are expanded in the order of what it costs to reach them, so the search "
               "grows evenly in all directions until it meets the goal. It needs no estimate.",
       .citation = "Dijkstra 1959",
       .guarantee_text = "optimal",
       .time = "O(n log n) in the n cells expanded; on uniform terrain the log is that of a "
               "small bucket",
       .memory = "8 bytes a cell and 16 an entry of the frontier; 16 and 24 on terrain or when "
                 "the search is watched",
       .bytes_per_cell = 8,
       .when = "Where no estimate is to be trusted, in mazes, and as the yardstick for all "
               "others. Elsewhere astar finds paths of the same cost and expands less.",
       .guarantee = Guarantee::optimal,
       .plans_on_terrain = true},
      choose_parts);
}

}  // namespace wend
