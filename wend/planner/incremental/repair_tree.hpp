#pragma once

// RepairTree: the cheapest paths to the goals, as a tree that is kept from search to search and repaired where the
// map changed.
//
// It is A* from the goals backwards: a node's g is the cost from its cell to a goal, and its arrival leads there.
// Keys are g + h(start) + km: when the start moves, km grows by the estimate between the old start and the new
// one, so keys never fall and what is open can stay where it is; an entry whose key has grown is moved when it
// comes up (S. Koenig and M. Likhachev, "D* Lite", 2002, have km from A. Stentz's Focussed D*).
//
// After an edit the tree is cut: nodes whose own cost changed, nodes whose move from the parent is no longer legal,
// and all their descendants are forgotten. What survives is a set of legal paths with the right costs. Every
// survivor beside a change or a forgotten node is opened again. Then the search goes on until no open node can
// lead to the start more cheaply.
//
// The moves that the class of a cell leaves out (CostGrid) need no more than that. A move is left out because a way
// over another neighbour is as good, and ends with a straight move, which is only left out where it is worse. If
// that neighbour, or the end, was forgotten, what leads there is beside it.
//
// Other goals, a new least cost of all cells, or more edits than the grid's log holds, begin a new tree.

#include <memory>

#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/grid/cost_grid.hpp"

namespace wend {

/// An engine on a grid, for parts with which it can_leap(). It keeps its tree while the goals are the same, and
/// follows the repairs of the grid. Expansions are counted from search to search; forgotten nodes are not.
template <class Word>
std::shared_ptr<GridEngine> make_repair_tree(const std::shared_ptr<const CostGrid<Word>>& grid,
                                             const BestFirst& parts);

}  // namespace wend
