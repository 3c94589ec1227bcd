#pragma once

// Best-first engines: the cheapest g + w h first, shared by dijkstra and astar. Costs are whole numbers.
// Where keys are too and never fall, uniform terrain is searched with sorted buckets, and cells with costs by
// the LeapEngine; everything else with a heap.

#include <memory>

#include "wend/planner/grid/grid_planner.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/grid_moves.hpp"
#include "wend/space/grid/heuristic.hpp"
#include "wend/space/grid/search_order.hpp"

namespace wend {

struct BestFirst {
  GridMoves moves;
  HeuristicKind heuristic;  // not automatic
  double constant;          // what HeuristicKind::constant is worth
  double weight;            // w >= 0
  bool leaps = true;        // on cells with costs, if they can be made
  SearchOrder order = {};   // if one is chosen, cells are expanded one by one in it

  /// Does f never fall along a path? Then the first expansion of a cell is its cheapest.
  bool consistent() const;

  /// Are keys sums of whole steps, and consistent?
  bool whole() const;

  /// Plan::bound: 1, or w above that, if the heuristic is consistent.
  double bound() const;
};

GridPlanner::Parts best_first_parts(const FreeSpace& space, const BestFirst& parts,
                                    DeadlineCheck& stop = DeadlineCheck::never());

}  // namespace wend
