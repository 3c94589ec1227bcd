#include "wend/index/run_writer.hpp"

#include <cassert>

#include "wend/space/grid/octile.hpp"

namespace wend {

void LegPath::append(Cell point) {
  const OctileWay way = octile_way(points_.back(), point);
  steps_.diagonal += static_cast<std::uint32_t>(way.diagonal);
  steps_.straight += static_cast<std::uint32_t>(way.straight);
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
