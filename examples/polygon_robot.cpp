// Plans for a robot whose shape is a polygon: the planner `lattice` sweeps it along every motion.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto loaded = wend::load_map("office.yaml");
  if (!loaded) return std::puts(loaded.error().message.c_str()), 2;
  const auto shape = wend::parse_footprint("0.35,0.2; 0.35,-0.2; -0.25,-0.2; -0.25,0.2");
  if (!shape) return std::puts(shape.error().message.c_str()), 2;
  wend::Session session(loaded->map, {.footprint = *shape});
  const auto answer = session.plan({{1, 1, 0}, {{{15, 9}, 0}}, {"lattice"}});
  if (!answer) return std::puts(answer.error().message.c_str()), 1;
  const bool free = !wend::first_collision(answer->path(), answer->space);
  std::printf("%zu poses, %s\n", answer->path().size(), free ? "free of collisions" : "not free");
}
