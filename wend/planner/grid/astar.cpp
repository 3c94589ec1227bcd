// A*: the cheapest g + w h first. P. Hart, N. Nilsson and B. Raphael, "A Formal Basis for the
// Heuristic Determination of Minimum Cost Paths", 1968; with a weight: I. Pohl, 1970.

#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/grid/grid_options.hpp"

namespace wend {
namespace {

GridPlanner::Parts astar_parts(const FreeSpace& space, const AStarOptions& options,
                               DeadlineCheck& stop) {
  const BestFirst parts{options.moves,
                        resolved(options.heuristic.kind, options.moves.connectivity),
                        options.heuristic.constant,
                        options.weight,
                        options.leaps,
                        options.order};
  return best_first_parts(space, parts, stop);
}

}  // namespace

PlannerInfo astar_planner() {
  return grid_planner<AStarOptions>(
      {.name = "astar",
       .summary = "A*: lowest cost so far plus estimate first",
       .idea = "A weight w multiplies the estimate. On terrain, after some queries, it finds side "
               "rooms: "
               "parts behind a narrow door that no cheapest path passes through. From then on it "
               "searches only those of the start and the goal.",
       .citation = "Hart, Nilsson, Raphael 1968; weighted: Pohl 1970",
       .guarantee_text =
           "optimal with a weight up to 1 and a heuristic that never overestimates; "
           "above 1 at most w times the optimum; manhattan on 8 neighbours: complete; "
           "on terrain at most 1.5e-6 of the cost more",
       .time =
           "O(n log n) in the n cells expanded; on uniform terrain log of a small bucket, on costs "
           "O(n)",
       .memory = "8 bytes per cell, 16 per frontier entry; on terrain 13 and 8, or 21 and 16 if "
                 "sums of costs outgrow 32 bits, and once side rooms are known 8 per run of free "
                 "cells in rows and in columns; 16 and 24 with leaps=false, with euclidean, with "
                 "manhattan on 8 neighbours, with a weight other than 0 and 1, or with an observer",
       .bytes_per_cell = 8,
       .when =
           "The default, also on terrain. In mazes it expands almost as many cells as dijkstra. "
           "A weight above 1 often expands far fewer cells, but each expansion takes several "
           "times as long.",
       .guarantee = Guarantee::bounded,
       .capabilities = {.leaps = true, .terrain = true, .learns = true}},
      astar_parts);
}

}  // namespace wend
