#pragma once

// A few expanded cells on a large map, which would vanish where many cells share a pixel: what a
// planner that jumps expands. sparse_dots.hpp draws them large enough to be seen.

#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/render/scene.hpp"

namespace wend {

/// The expanded cells without expanded neighbours, which need dots of so many pixels across in a
/// picture of so many pixels a cell: none where cells are as large, or so many that the dots would
/// hide the map. O(cells).
std::vector<Cell> sparse_cells(const MarkedCells& marked, double pixels_a_cell, double dot);

}  // namespace wend
