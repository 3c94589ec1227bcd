#include "wend/index/leg_path.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstdlib>

#include "wend/index/run_writer.hpp"

namespace wend {

void LegPath::append(Cell point) {
  const Cell last = points_.back();
  const int dx = std::abs(point.x - last.x);
  const int dy = std::abs(point.y - last.y);
  steps_.diagonal += static_cast<std::uint32_t>(std::min(dx, dy));
  steps_.straight += static_cast<std::uint32_t>(std::abs(dx - dy));
  points_.push_back(point);
}

void LegPath::write(std::span<Cell> cells) const {
  assert(cells.size() == steps_.cells());
  const Cell start = points_.front();
  cells.front() = start;
  RunWriter<1> writer(cells.data() + 1, cells.size() - 1, start);
  for (const Cell point : points_) writer.go_to(point);
}

}  // namespace wend
