#pragma once

// Cells of the page: a byte each, row by row, cell (0, 0) first: 0 an obstacle, 255 unknown, else the cost of a
// unit of length in a free cell (1: normal ground).

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/map/grid_map.hpp"

namespace wend::lab {

inline constexpr std::uint8_t kObstacle = 0;
inline constexpr std::uint8_t kUnknownCell = 255;
inline constexpr double kDearest = 254;

/// The state that a byte stands for.
constexpr CellState state_of(std::uint8_t cell) {
  if (cell == kObstacle) return CellState::occupied;
  return cell == kUnknownCell ? CellState::unknown : CellState::free;
}

/// What a unit of length costs there, at least 1.
constexpr double cost_of(std::uint8_t cell) {
  return cell == kObstacle || cell == kUnknownCell ? 1 : cell;
}

/// A map of these cells. Fails as make_grid_map() does.
Expected<GridMap, Error> map_of(std::span<const std::uint8_t> cells, int width, int height,
                                const Frame& frame);

/// The bytes of a map. Costs are rounded to whole numbers.
std::vector<std::uint8_t> cells_of(const GridMap& map);

}  // namespace wend::lab
