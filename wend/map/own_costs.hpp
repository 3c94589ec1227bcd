#pragma once

// Costs of one's own: a multiplier for each cell, from a buffer or from a function of the cell.
//
//   const auto cost_of = [](wend::Cell cell) { return cell.y < 5 ? 3.0 : 1.0; };
//   const auto muddy = wend::with_terrain(map, cost_of);
//   if (!muddy) return report(muddy.error().message);

#include <type_traits>
#include <utility>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/map/grid.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// The map with these multipliers in place of its own; an empty grid: 1 everywhere. Fails with invalid_map if
/// the sizes differ, or if a multiplier is not finite or below 1. O(cells).
WEND_API Expected<GridMap, Error> with_terrain(const GridMap& map, Grid<double> terrain);

/// The same with `cost_of(cell)` for each cell, called once, row by row. The middle of a cell in metres is
/// `map.frame().to_metres(wend::centre_of(cell))`.
template <class CostOf>
  requires std::is_invocable_r_v<double, CostOf&, Cell>
Expected<GridMap, Error> with_terrain(const GridMap& map, CostOf&& cost_of) {
  Grid<double> terrain(map.width(), map.height());
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) terrain[{x, y}] = cost_of(Cell{x, y});
  }
  return with_terrain(map, std::move(terrain));
}

}  // namespace wend
