// Dijkstra's algorithm: the cheapest g first. E. W. Dijkstra, "A Note on Two Problems in Connexion
// with Graphs", 1959.

#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/grid/grid_options.hpp"

namespace wend {
namespace {

GridPlanner::Parts dijkstra_parts(const FreeSpace& space, const DijkstraOptions& options,
                                  DeadlineCheck& stop) {
  return best_first_parts(
      space, {options.moves, HeuristicKind::zero, 0, 0, options.leaps, options.order}, stop);
}

}  // namespace

PlannerInfo dijkstra_planner() {
  return grid_planner<DijkstraOptions>(
      {.name = "dijkstra",
       .summary = "Dijkstra: lowest cost from the start first",
       .idea =
           "The search grows evenly in all directions and needs no estimate. On terrain it leaves "
           "out side rooms as astar does.",
       .citation = "Dijkstra 1959",
       .guarantee_text = "optimal; on terrain at most 1.5e-6 of the cost more",
       .time =
           "O(n log n) in the n cells expanded; on uniform terrain log of a small bucket, on costs "
           "O(n)",
       .memory = "8 bytes per cell, 16 per frontier entry; on terrain 13 and 8, or 21 and 16 if "
                 "sums of costs outgrow 32 bits, and once side rooms are known 8 per run of free "
                 "cells in rows and in columns; 16 and 24 with leaps=false or with an observer",
       .bytes_per_cell = 8,
       .when = "In mazes, and as a baseline; elsewhere astar expands fewer cells.",
       .guarantee = Guarantee::optimal,
       .capabilities = {.leaps = true, .terrain = true, .learns = true}},
      dijkstra_parts);
}

}  // namespace wend
