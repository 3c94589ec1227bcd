#include "lab/wasm/cells.hpp"

#include <algorithm>
#include <utility>

namespace wend::lab {

Expected<GridMap, Error> map_of(std::span<const std::uint8_t> cells, int width, int height,
                                const Frame& frame) {
  BitGrid occupied(width, height);
  BitGrid unknown(width, height);
  std::vector<double> terrain;
  std::size_t index = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, ++index) {
      const CellState state = state_of(cells[index]);
      if (state == CellState::occupied) occupied.set({x, y}, true);
      if (state == CellState::unknown) unknown.set({x, y}, true);
      const double cost = cost_of(cells[index]);
      if (cost > 1 && terrain.empty()) terrain.resize(cells.size(), 1);
      if (cost > 1) terrain[index] = cost;
    }
  }
  Grid<double> costs;
  if (!terrain.empty()) costs = Grid<double>(width, height, std::move(terrain));
  return make_grid_map(std::move(occupied), std::move(unknown), frame, std::move(costs));
}

std::vector<std::uint8_t> cells_of(const GridMap& map) {
  std::vector<std::uint8_t> cells;
  cells.reserve(map.size());
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      switch (map.state({x, y})) {
        case CellState::occupied:
          cells.push_back(kObstacle);
          break;
        case CellState::unknown:
          cells.push_back(kUnknownCell);
          break;
        case CellState::free:
          cells.push_back(static_cast<std::uint8_t>(
              std::clamp(std::round(map.terrain({x, y})), 1.0, kDearest)));
      }
    }
  }
  return cells;
}

}  // namespace wend::lab
