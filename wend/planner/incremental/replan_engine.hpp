#pragma once

// ReplanEngine: plans again and again while the map changes and the robot moves. If what is left of the last path is
// still a cheapest one, it is the answer, and nothing is searched (KeptPath). Else it searches from scratch with leaps
// (LeapEngine): on recorded drives, that was as fast as repairing the tree of the last search where that pays, and
// faster elsewhere.

#include "wend/planner/grid/best_first.hpp"

namespace wend {

/// The engine and what follows edits, for parts with which it can_leap().
GridPlanner::Parts replan_parts(const FreeSpace& space, const BestFirst& parts,
                                DeadlineCheck& stop = DeadlineCheck::never());

}  // namespace wend
