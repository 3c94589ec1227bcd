#pragma once

// ReplanEngine: plans again and again while the map changes and the robot moves. It asks in this order:
//
// 1. Is what is left of the last path still a cheapest one? (KeptPath; nothing is searched)
// 2. Does the tree of the last searches, repaired, lead to the robot? (RepairTree)
// 3. Else a search from scratch that leaps. (LeapEngine)
//
// Where every cell costs the same, 3 is the faster one. Else neither is on every map, and how large a repair is cannot be known before it is done. So the
// tree has a budget: a share of the work of the leaping searches, and what it saved before. It is asked when
// the budget covers what it needed last; if it does not end within the budget, the search leaps, and the
// tree goes on where it stopped when it is asked again. So all searches together take at most that share longer
// than leaping searches would.

#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/incremental/incremental_options.hpp"

namespace wend {

/// The engine and what follows edits, for parts with which it can_leap().
GridPlanner::Parts replan_parts(const FreeSpace& space, const BestFirst& parts, ReplanSearch search,
                                DeadlineCheck& stop = DeadlineCheck::never());

}  // namespace wend
