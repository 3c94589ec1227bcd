// Loads a map, plans in metres for a disc, and prints the path.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto loaded = wend::load_map("office.yaml");
  if (!loaded) return std::puts(loaded.error().message.c_str()), 2;
  const auto space = wend::make_free_space(loaded->map, {.footprint = wend::Footprint::disc(0.2)});
  if (!space) return std::puts(space.error().message.c_str()), 2;
  const auto planner = wend::make_planner("astar", *space);
  if (!planner) return std::puts(planner.error().message.c_str()), 2;
  const wend::Frame& frame = loaded->map.frame();
  const auto plan = (*planner)->plan({frame.to_grid({1, 1, 0}), {frame.to_grid({15, 6.8, 0})}});
  if (!plan) return std::puts(plan.error().message.c_str()), 1;
  for (const wend::Point point : plan->path.points_in_metres(frame)) {
    std::printf("%.2f %.2f\n", point.x, point.y);
  }
}
