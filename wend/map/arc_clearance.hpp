#pragma once

// Clearance of an arc: the distance from the nearest of its points to the nearest closed obstacle
// square, exact up to rounding; and whether a robot can drive along it.
//
// Arcs are in grid coordinates, finite, and turn by at most 2 pi. They may touch the map's border or
// leave the map: cells outside it are no obstacles.
//
//   const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});  // from corner to corner of cell (0,0)
//   if (wend::fits_along(space, arc)) length += arc.length;

#include "wend/geometry/arc.hpp"
#include "wend/map/free_space.hpp"

namespace wend {

/// In cells; 0 where the arc touches an obstacle, infinite without obstacles. Of an arc of length 0:
/// that of its point. O(cells of a box around the arc as wide as what the clearance of the cells
/// that it passes leaves open).
double arc_clearance(const FreeSpace& space, const Arc& arc);

/// Does the space's robot keep far enough from every obstacle, by FreeSpace::far_enough(), along the
/// whole arc? A point does everywhere: it has no width. O(1) for each length of arc that the
/// clearance of a cell decides, else O(cells within the radius).
bool fits_along(const FreeSpace& space, const Arc& arc);

}  // namespace wend
