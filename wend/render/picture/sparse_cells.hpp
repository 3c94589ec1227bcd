#pragma once

// A few expanded cells on a large map, which would vanish where many cells share a pixel: what a
// planner that jumps expands. sparse_dots.hpp draws them large enough to be seen.

#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/render/scene.hpp"

namespace wend {

/// The expanded cells without expanded neighbours, which a picture shows as dots. None if cells are at
/// least as large as dots, or if the dots would hide the map. Sizes in pixels. O(cells).
std::vector<Cell> sparse_cells(const MarkedCells& marked, double pixels_a_cell, double dot);

}  // namespace wend
