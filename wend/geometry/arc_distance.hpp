#pragma once

// How far an arc is from points and from the squares of cells: the distance from the nearest of its
// points. Exact up to rounding, also where the arc is nearly straight; O(1).
//
//   const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});       // around the centre (0,1)
//   const double gap = wend::distance(arc, wend::Cell{1, -1});  // sqrt(2) - 1, at (1,0)
//
// Arcs turn by at most 2 pi. Coordinates are those of the grid. What is nearer than 1e-12 cells
// touches: that is rounding, and its distance is 0.

#include "wend/geometry/arc.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// From a point to the closed square [x, x+1] x [y, y+1] of a cell; 0 inside.
double distance(Point point, Cell square);

double distance(const Arc& arc, Point point);

/// To the closed square of a cell; 0 where the arc touches it, crosses it or lies inside.
double distance(const Arc& arc, Cell square);

}  // namespace wend
