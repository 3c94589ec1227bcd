#include "wend_ros/costmap.hpp"

#include <cassert>
#include <cstddef>
#include <utility>

namespace wend_ros {

wend::GridMap map_from_costs(std::span<const std::uint8_t> costs, int width, int height,
                             double resolution, wend::MapPoint origin) {
  constexpr std::uint8_t kUnknown = 255;
  constexpr std::uint8_t kInscribed = 253;
  constexpr double kRoughest = 252;
  constexpr double kScale = 4;
  assert(costs.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  wend::Grid<wend::CellState> cells(width, height, wend::CellState::free);
  wend::Grid<double> terrain(width, height, 1);
  std::size_t i = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t cost = costs[i++];
      if (cost == kUnknown) {
        cells[{x, y}] = wend::CellState::unknown;
      } else if (cost >= kInscribed) {
        cells[{x, y}] = wend::CellState::occupied;
      } else {
        terrain[{x, y}] = 1 + kScale * cost / kRoughest;
      }
    }
  }
  return *wend::make_grid_map(
      cells,
      {.resolution = resolution, .origin = {origin.x, origin.y, 0}, .y_up = true, .metric = true},
      std::move(terrain));
}

}  // namespace wend_ros
