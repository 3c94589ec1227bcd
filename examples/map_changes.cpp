// The map changes while a robot drives: edits it, and plans again from what was found before.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto map = wend::parse_map(".......\n...#...\n...#...\n.......\n", "map.txt");
  if (!map) return std::puts(map.error().message.c_str()), 2;
  wend::Session session(map->map);
  const wend::PlanRequest request{{0.5, 0.5, 0}, {{{6.5, 0.5}}}};
  const auto before = session.replan(request);
  if (!before) return std::puts(before.error().message.c_str()), 1;
  std::printf("cost %.2f\n", before->plan.cost);
  const wend::MapEdit door{.cells = {{{3, 0}, wend::CellState::occupied}}};
  if (const auto change = session.edit(door); !change) return std::puts("not on the map"), 1;
  const auto after = session.replan(request);
  if (!after) return std::puts(after.error().message.c_str()), 1;
  std::printf("with the upper door closed: cost %.2f\n", after->plan.cost);
}
