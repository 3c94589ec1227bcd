#pragma once

// Clearance of the straight way between the centres of two cells: the distance from the nearest of
// its points to the nearest closed obstacle square, or to the map's edge if the outside is blocked,
// exact.

#include <cstdint>

#include "wend/map/free_space.hpp"

namespace wend {

/// Of the way between a cell and one of its eight neighbours (or itself): squared and in half-cells,
/// like FreeSpace::squared_half_cell_clearance(); 0 where a diagonal way touches an obstacle.
/// Both cells are on the map. O(1).
std::uint32_t squared_half_cell_way_clearance(const FreeSpace& space, Cell from, Cell to);

/// Of the way between any two cells of the map, in cells; infinite where nothing is near. O(1) for
/// neighbours, else as arc_clearance().
double way_clearance(const FreeSpace& space, Cell from, Cell to);

}  // namespace wend
