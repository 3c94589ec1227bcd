#pragma once

// Cells of a generated map that an exercise needs: a start and a goal, and a way between them.

#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

struct KeptCells {
  GridMap map;
  std::vector<Cell> opened{};  // what else was freed
};

/// The map with these cells free, and others where no path over edges of free cells joins them: each is joined to those
/// before it by a path through as few other cells that are not free as possible. Cells must be on the map.
/// O(cells of the map) for each that is not joined yet.
WEND_API Expected<KeptCells, Error> keep_cells(const GridMap& map, const std::vector<Cell>& cells);

}  // namespace wend
