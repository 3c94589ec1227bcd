#pragma once

// What a laser scanner in the middle of a cell sees of a map.

#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/map/obstacles.hpp"

namespace wend {

/// Appends the cells that are seen from a cell of the map: `from` itself, and those at a distance of at most
/// `range` cells (centre to centre, at least 0, finite) to which a ray leads that no blocked cell stops before.
/// The blocked cell that stops a ray is seen. Rays lead along the nearest cells of the lines to all cells of the
/// square around the range, so a ray may pass between two blocked cells that touch at a corner. A cell may be
/// appended more than once. O(range^2).
WEND_API void append_visible_cells(const Obstacles& obstacles, Cell from, double range,
                                   std::vector<Cell>& cells);

}  // namespace wend
