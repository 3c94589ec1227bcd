#pragma once

// What a laser scanner that looks all around sees of a map.
//
// The rays are exact: they are followed from border to border of the cells. Their directions and crossings need
// no trigonometry. What is seen from the middle of a cell depends on no rounding.

#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/obstacles.hpp"

namespace wend {

/// Appends the cells that are seen from a point in grid coordinates: the cell of the point, and those with their
/// centre at most `range` cells away (at least 0; infinite: all the map) to which a ray leads that no blocked cell
/// stops before. The blocked cell that stops a ray is seen; the cell of the point stops none. A ray through a corner
/// of cells passes unless both cells beside it are blocked. The ends of two rays lie half a cell apart, so a
/// narrower slit far away may be missed. Each cell is appended once, in no order; none if the point is not on the
/// map, or if the range is NaN or negative. O(range^2).
WEND_API void append_visible_cells(const Obstacles& obstacles, Point from, double range,
                                   std::vector<Cell>& cells);

}  // namespace wend
