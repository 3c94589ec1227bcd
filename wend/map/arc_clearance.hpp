#pragma once

// Clearance of an arc or a line: the distance from the nearest of its points to the nearest closed
// obstacle square, or to the map's edge if the outside is blocked, exact up to rounding; and whether a
// robot can drive along it.
//
// Arcs and lines are in grid coordinates, finite; arcs turn by at most 2 pi. They may touch the
// map's edge or leave the map. Where the outside is free, it is no obstacle.
//
//   const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});  // from corner to corner of cell (0,0)
//   if (wend::fits_along(space, arc)) length += arc.length;

#include "wend/geometry/arc.hpp"
#include "wend/geometry/line.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/map/free_space.hpp"

namespace wend {

/// In cells; 0 where the arc touches an obstacle, infinite where nothing is near. Of an arc of length 0:
/// that of its point. O(cells of a box around the arc as wide as what the clearance of the cells
/// that it passes leaves open).
double arc_clearance(const FreeSpace& space, const Arc& arc);

/// May the space's robot drive along the whole arc or line? A disc keeps far enough from every
/// obstacle, and from the map's edge if the outside is blocked, by FreeSpace::far_enough(). A point
/// (radius 0) may go anywhere outside the map; it keeps out of the union of the obstacles and, unless `adjacency` is edges_and_corners, does not pass between two that touch at a corner
/// (point_sweep.hpp has the exact rules). O(1) for each length that the clearance of a cell
/// decides, else O(cells within the radius).
bool fits_along(const FreeSpace& space, const Arc& arc, Adjacency adjacency = Adjacency::edges);
bool fits_along(const FreeSpace& space, const Line& line, Adjacency adjacency = Adjacency::edges);

}  // namespace wend
