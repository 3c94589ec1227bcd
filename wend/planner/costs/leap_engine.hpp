#pragma once

// LeapEngine: the cheapest g + h first on cells with costs, in whole numbers, with leaps.
//
// A step between neighbours costs (a + b) * 408, a diagonal one (a + b) * 577, where a and b are the CostMap
// steps of its two cells (CostUnits says how close that is); where every cell costs the same, OctileUnits stand
// for 408 and 577.
//
// The moves that the class of a cell leaves out (CostGrid) keep a cheapest path to every cell: one that is
// left out on a tie is the second of two moves, a diagonal one, and the other way ends with a straight move,
// which is never left out on a tie. On top of that, on 8 neighbours:
//
// - A straight step into an interior cell leaps: it runs on to the first cell that is not interior, or to a
//   goal. The interior cells between would only have run on.
// - An interior cell that was reached diagonally is dominated if a longer straight run reached the end of one
//   of its own two runs more cheaply: that run passed the cell, and more cheaply.
// - After a straight step, elsewhere than in the uniform class, a diagonal step is left out if the diagonal
//   step from the parent, then a straight one, costs no more.
//
// Buckets are not sorted, so cells may be expanded again; the search goes on until no open cell can lead to a
// goal more cheaply. An observer sees each expansion, also repeated ones, and a leap as one step from its
// first cell.
//
// Once searches have taken about as long as finding the SideRooms of the map, these are found, and closed where a query
// does not begin or end in them.
//
// Where a disc may cut corners, what is a legal move depends on more than the 3 x 3 block, and the classes do
// not hold; weights and other heuristics have real keys: a forward search on TerrainGrid serves these.

#include <cstdint>
#include <memory>

#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/costs/landmarks.hpp"
#include "wend/planner/grid/best_first.hpp"
#include "wend/search/rounds.hpp"

namespace wend {

/// Can a leap engine search with these parts? Any moves, unless a disc cuts corners; a consistent estimate
/// in whole numbers.
bool can_leap(const FreeSpace& space, const BestFirst& parts);

/// An engine on a grid, for parts with which it can_leap(). It follows the repairs of the grid. On a map where
/// every cell costs the same its costs are exact (OctileUnits). Landmarks, if there are any, make its estimate
/// larger until a repair may make their bounds wrong.
template <class Word>
std::shared_ptr<GridEngine> make_leap_engine(
    const std::shared_ptr<const CostGrid<Word>>& grid, const BestFirst& parts,
    const std::shared_ptr<const Landmarks>& landmarks = nullptr);

/// The engine, with this number of landmarks, and what repairs it after an edit. No use if the deadline passes before.
GridPlanner::Parts leap_parts(const FreeSpace& space, const BestFirst& parts,
                              unsigned landmarks = 0, DeadlineCheck& stop = DeadlineCheck::never());

/// The same for an anytime search without landmarks.
GridPlanner::Parts anytime_leap_parts(const FreeSpace& space, const BestFirst& parts,
                                      AnytimeWeights weights, DeadlineCheck& stop);

}  // namespace wend
