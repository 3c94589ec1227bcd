// Plans for a robot whose shape is a polygon: the planner `lattice` sweeps it along every motion.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto loaded = wend::load_map("office.yaml");
  if (!loaded) return std::puts(loaded.error().message.c_str()), 2;
  const auto shape = wend::parse_footprint("0.35,0.2; 0.35,-0.2; -0.25,-0.2; -0.25,0.2");
  if (!shape) return std::puts(shape.error().message.c_str()), 2;
  const auto space = wend::make_free_space(loaded->map, {.footprint = *shape}).value();
  const auto planner = wend::make_planner("lattice", space);
  if (!planner) return std::puts(planner.error().message.c_str()), 2;
  const wend::Frame& frame = loaded->map.frame();
  const auto plan = (*planner)->plan({frame.to_grid({1, 1, 0}), {frame.to_grid({15, 9, 0})}});
  if (!plan) return std::puts(plan.error().message.c_str()), 1;
  const bool free = !wend::first_collision(plan->path, space);
  std::printf("%zu poses, %s\n", plan->path.size(), free ? "free of collisions" : "not free");
}
