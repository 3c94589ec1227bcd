// Computes the cost from every cell to a goal, and the best move in each.
#include <array>
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto map = wend::parse_map("......\n.####.\n......\n", "map.txt");
  if (!map) return std::puts(map.error().message.c_str()), 2;
  const auto space = wend::make_free_space(map->map).value();
  const auto field = wend::CostToGo::make(space, std::array{wend::Cell{0, 1}});
  if (!field) return std::puts(field.error().message.c_str()), 1;
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      const auto move = field->policy({x, y});
      std::printf("%4.1f %-2s", field->cost({x, y}),
                  move ? name_of(*move, map->map.frame()).data() : "");
    }
    std::puts("");
  }
}
