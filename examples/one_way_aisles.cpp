// Ways with a direction: a warehouse whose aisles are one-way streets.
#include <cmath>
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  // Five shelves of four rows between aisles; the last column and the first join them.
  wend::Grid<wend::CellState> cells(24, 11, wend::CellState::free);
  wend::Grid<double> headings(24, 11, std::nan(""));  // no arrow
  for (int y = 0; y < 11; ++y) {
    for (int x = 2; x < 22; ++x) {
      if (y % 2 == 1) cells[{x, y}] = wend::CellState::occupied;
      // The aisles lead to the right and to the left in turn.
      if (y % 2 == 0) headings[{x, y}] = y % 4 == 0 ? 0 : wend::kPi;
    }
  }
  const auto map = wend::make_grid_map(cells).value();
  const auto one_way = wend::with_arrows(map, headings).value();
  const auto dear = wend::with_arrows(map, headings, {.factor = 1.25}).value();

  const auto query = wend::Query::between({21, 4}, {2, 4});  // against its aisle
  for (const wend::GridMap& each : {map, one_way, dear}) {
    const auto space = wend::make_free_space(each).value();
    const auto plan = wend::make_planner("astar", space).value()->plan(query);
    if (!plan) return std::puts(plan.error().message.c_str());
    std::printf("cost %.2f, %zu cells\n", plan->cost, plan->path.size());
  }
  // A planner that does not know directions says so.
  const auto refused = wend::make_planner("jps", wend::make_free_space(one_way).value());
  std::puts(refused.error().message.c_str());
}
