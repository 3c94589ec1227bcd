#pragma once

// The distance from an arc to points and to the squares of cells: from the nearest point of the arc.
// Exact up to rounding, even for arcs that are nearly straight; O(1).
//
//   const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});       // around the centre (0,1)
//   const double gap = wend::distance(arc, wend::Cell{1, -1});  // sqrt(2) - 1, at (1,0)
//
// Arcs turn by at most 2 pi. Coordinates are grid coordinates. Distances below 1e-12 cells are rounding
// and count as 0: the two touch.

#include "wend/geometry/arc.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// The distance from a point to the closed square [x, x+1] x [y, y+1] of a cell; 0 inside.
double distance(Point point, Cell square);

double distance(const Arc& arc, Point point);

/// The distance to the closed square of a cell; 0 if the arc touches it, crosses it or lies inside.
double distance(const Arc& arc, Cell square);

}  // namespace wend
