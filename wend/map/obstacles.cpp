#include "wend/map/obstacles.hpp"

#include <algorithm>

#include "wend/map/distance_field.hpp"

namespace wend {
namespace {

BitGrid blocked_cells(const GridMap& map, UnknownPolicy unknown) {
  BitGrid blocked = map.occupied();
  if (unknown == UnknownPolicy::free) return blocked;
  for (int y = 0; y < map.height(); ++y) {
    const auto words = blocked.row_words(y);
    const auto unknown_words = map.unknown().row_words(y);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] |= unknown_words[i];
  }
  return blocked;
}

/// The squared distance from a cell's centre to the map's edge, in half-cells.
std::uint32_t squared_half_cells_to_edge(const BitGrid& map, Cell cell) {
  const std::int64_t cells =
      std::min({cell.x, map.width() - 1 - cell.x, cell.y, map.height() - 1 - cell.y});
  return static_cast<std::uint32_t>((2 * cells + 1) * (2 * cells + 1));
}

/// The clearance of each cell's centre: to the nearest blocked cell or, if it counts, the map's edge.
Grid<std::uint32_t> clearance_of(const BitGrid& blocked, OutsidePolicy outside) {
  Grid<std::uint32_t> clearance = squared_half_cell_distances(blocked);
  if (outside == OutsidePolicy::free) return clearance;
  for (const Cell cell : every_cell(clearance)) {
    std::uint32_t& here = clearance[cell];
    here = std::min(here, squared_half_cells_to_edge(blocked, cell));
  }
  return clearance;
}

}  // namespace

OutsidePolicy default_outside_policy(const Frame& frame) {
  return frame.metric ? OutsidePolicy::blocked : OutsidePolicy::free;
}

Obstacles::Obstacles(GridMap map, ObstacleOptions options) {
  const OutsidePolicy outside = options.outside.value_or(default_outside_policy(map.frame()));
  BitGrid blocked = blocked_cells(map, options.unknown);
  Grid<std::uint32_t> clearance = clearance_of(blocked, outside);
  data_ = std::make_shared<const Data>(
      Data{std::move(map), options.unknown, outside, std::move(blocked), std::move(clearance)});
}

double Obstacles::clearance(Cell cell) const { return distance_in_cells(data_->clearance[cell]); }

bool Obstacles::edge_is_nearest(Cell cell) const {
  return outside() == OutsidePolicy::blocked &&
         data_->clearance[cell] == squared_half_cells_to_edge(data_->blocked, cell);
}

}  // namespace wend
