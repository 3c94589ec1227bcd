// Runs where there is nothing but WebAssembly: plans around a wall, and says 0 if all is as
// elsewhere.

#include <cmath>
#include <cstdio>

#include "wend/map/grid.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/planner/planners.hpp"

int main() {
  wend::Grid<wend::CellState> cells(10, 7, wend::CellState::free);
  for (int y = 2; y <= 4; ++y) cells[{5, y}] = wend::CellState::occupied;
  const wend::FreeSpace space = *wend::make_free_space(*wend::make_grid_map(cells));

  const auto planner = wend::make_planner("astar", space);
  if (!planner) return 1;
  const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
  if (!plan) return 1;

  std::printf("cost %g, %zu cells\n", plan->cost, plan->path.size());
  const double around_the_lower_end = 5 + 3 * std::sqrt(2.0);
  return std::abs(plan->cost - around_the_lower_end) < 1e-9 ? 0 : 1;
}
