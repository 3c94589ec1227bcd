#pragma once

// Ordered engines: the searches of bfs, dfs, greedy, dijkstra and astar in an order that was asked for (SearchOrder),
// cell by cell. They exist beside the fast ones, which are free to choose, and cost those nothing.

#include <memory>

#include "wend/planner/grid/grid_planner.hpp"
#include "wend/space/grid/heuristic.hpp"
#include "wend/space/grid/search_order.hpp"

namespace wend {

/// What an ordered search expands first: the least f = g_share g + weight h.
struct OrderedSearch {
  GridMoves moves;
  SearchOrder order;
  HeuristicKind heuristic = HeuristicKind::zero;  // not automatic
  double constant = 0;                            // what HeuristicKind::constant is worth
  double g_share = 0;
  double weight = 0;
  bool fewest_steps = false;  // among ways of as few steps a cell keeps the shortest one
};

/// A cell keeps the way by which it was reached first: bfs, dfs, greedy.
std::unique_ptr<GridEngine> make_first_way_engine(const FreeSpace& space,
                                                  const OrderedSearch& search);

/// A cell that is reached more cheaply takes the new way: dijkstra, astar.
std::unique_ptr<GridEngine> make_cheapest_way_engine(const FreeSpace& space,
                                                     const OrderedSearch& search);

}  // namespace wend
