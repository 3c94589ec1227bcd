#pragma once

// The room in which the tests of sessions plan.

#include "wend/map/grid_map.hpp"
#include "wend/session/plan_request.hpp"

namespace wend::test {

/// A room of 10 x 10 m at 0.1 m a cell, its lower left corner at (-2,-3), with a wall that leaves a way at
/// the top.
inline GridMap walled_room() {
  Grid<CellState> cells(100, 100, CellState::free);
  for (int y = 0; y < 80; ++y) cells[{50, y}] = CellState::occupied;
  return *make_grid_map(cells,
                        {.resolution = 0.1, .origin = {-2, -3, 0}, .y_up = true, .metric = true});
}

inline PlanRequest across() { return {.start = {-0.95, -1.95, 0}, .goals = {{{7.05, -1.95}}}}; }

}  // namespace wend::test
