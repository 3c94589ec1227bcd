#pragma once

// LeapEngine: the cheapest g + h first on cells with costs, in whole numbers, with leaps.
//
// A step between neighbours costs (a + b) * 408, a diagonal one (a + b) * 577, where a and b are the CostMap
// steps of its two cells. 577 / 408 is the square root of 2 to 1.1e-6, so the cost of the path found exceeds
// the cheapest by at most that share.
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
// goal more cheaply. It counts the expansions of cells, not those that leaps pass.

#include <memory>

#include "wend/planner/grid/best_first.hpp"

namespace wend {

/// An engine for cells with costs, by any moves where no disc cuts corners; `parts` must be a consistent
/// estimate in whole numbers. It has no observers and no steps, and lists no open cells.
std::unique_ptr<GridEngine> make_leap_engine(const FreeSpace& space, const BestFirst& parts);

}  // namespace wend
