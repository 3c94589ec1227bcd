#pragma once

// cells_in_sight(): is the straight line between the centres of two cells free for a point? In whole numbers, row by row
// and up to 64 cells at a time.
//
// The line may touch the corner of an obstacle, and passes between two that touch at a corner only with
// Adjacency::edges_and_corners: the rules of disc_fits_along() for a point, with the same answers.

#include "wend/geometry/cell.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/connected_components.hpp"

namespace wend {

/// Both cells are on the map. O(rows between them + cells / 64).
bool cells_in_sight(const BitGrid& blocked, Cell a, Cell b, Adjacency adjacency);

}  // namespace wend
