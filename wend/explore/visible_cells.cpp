#include "wend/explore/visible_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace wend {
namespace {

/// value * i / n to the nearest whole number, halves up.
int part_of(int value, int i, int n) {
  const std::int64_t twice = 2 * std::int64_t{value} * i + n;
  const std::int64_t below = twice / (2 * n) - (twice % (2 * n) < 0 ? 1 : 0);
  return static_cast<int>(below);
}

}  // namespace

void append_visible_cells(const Obstacles& obstacles, Cell from, double range,
                          std::vector<Cell>& cells) {
  const GridMap& map = obstacles.map();
  cells.push_back(from);
  // No ray leads further than over the map.
  const int reach = static_cast<int>(
      std::min(std::floor(range), static_cast<double>(std::max(map.width(), map.height()))));
  const double most = range * range;
  const auto cast = [&](int dx, int dy) {
    const int steps = std::max(std::abs(dx), std::abs(dy));
    for (int i = 1; i <= steps; ++i) {
      const Cell step{part_of(dx, i, steps), part_of(dy, i, steps)};
      const Cell cell{from.x + step.x, from.y + step.y};
      const double squared =
          static_cast<double>(step.x) * step.x + static_cast<double>(step.y) * step.y;
      if (squared > most || !map.contains(cell)) return;
      cells.push_back(cell);
      if (obstacles.blocked()[cell]) return;
    }
  };
  for (int i = -reach; i <= reach; ++i) {
    cast(i, -reach);
    cast(i, reach);
    if (std::abs(i) == reach) continue;
    cast(-reach, i);
    cast(reach, i);
  }
}

}  // namespace wend
