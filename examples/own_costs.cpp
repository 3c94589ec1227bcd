// Costs of one's own: a function of the cell, a costmap buffer of ROS, and a mask over both.
#include <cstdint>
#include <cstdio>
#include <vector>

#include "wend/wend.hpp"

void print_plan(const char* costs, const wend::GridMap& map) {
  const auto space = wend::make_free_space(map).value();
  const auto plan =
      wend::make_planner("astar", space).value()->plan(wend::Query::between({0, 2}, {8, 2}));
  if (!plan) return void(std::puts(plan.error().message.c_str()));
  std::printf("%s: cost %.2f, %zu cells\n", costs, plan->cost, plan->path.size());
}

int main() {
  // A costmap of costmap_2d: 0 to 252 are costs, 253 and 254 are blocked, 255 is unknown.
  const std::vector<std::uint8_t> costs(9 * 5, 126);
  const wend::Frame frame{.resolution = 0.05, .y_up = true, .metric = true};
  const auto map = wend::map_from_costmap(costs, 9, 5, frame).value();
  print_plan("costmap", map);

  const auto cost_of = [](wend::Cell cell) { return cell.y < 4 ? 3.0 : 1.0; };
  const auto muddy = wend::with_terrain(map, cost_of).value();
  print_plan("function of the cell", muddy);

  wend::Grid<wend::CellState> zones(9, 5, wend::CellState::free);
  zones[{4, 4}] = wend::CellState::occupied;
  const auto mask = wend::make_grid_map(zones, frame).value();
  print_plan("keep-out mask", wend::masked(muddy, mask).value());
}
