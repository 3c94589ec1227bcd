// Explains why there is no path, and which changes would open one.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto map = wend::parse_map("..#...\n.....#\n..#...\n..#...\n", "map.txt");
  if (!map) return std::puts(map.error().message.c_str()), 2;
  const auto space =
      wend::make_free_space(map->map, {.footprint = wend::Footprint::disc(0.8)}).value();
  const auto planner = wend::make_planner("astar", space);
  const auto plan = (*planner)->plan(wend::Query::between({0, 0}, {4, 3}));
  if (!plan) std::puts(plan.error().message.c_str());
  for (const wend::Way& way : wend::explain_no_path(space, {0, 0}, {4, 3}).ways) {
    std::printf("%s%s%sa robot with a radius of %.2f cells passes\n",
                way.unknown_free ? "unknown cells free: " : "",
                way.squeeze ? "between corners: " : "", way.smaller_robot ? "smaller: " : "",
                way.widest.radius);
  }
}
