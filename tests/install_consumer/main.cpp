#include <cstdio>

#include "wend/io/map/load_map.hpp"
#include "wend/planner/planners.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto loaded = wend::load_map(argv[1]);
  if (!loaded) {
    std::puts(loaded.error().message.c_str());
    return 2;
  }
  const wend::FreeSpace space =
      *wend::make_free_space(loaded->map, {.footprint = wend::Footprint::disc(0.0)});
  const auto planner = wend::make_planner("astar", space);
  const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
  if (!plan) return 1;
  std::printf("cost %g, %zu cells\n", plan->cost, plan->path.size());
}
