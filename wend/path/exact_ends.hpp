#pragma once

// with_ends(): a path from cell to cell, or over waypoints, that begins and ends at points of its first and last cell in
// place of their centres.
//
//   const wend::PathEnds ends{{1.4, 1.6}, {8.3, 5.7}};
//   const wend::Path path = wend::with_ends(plan->path, ends, space);
//
// At each end on its own: the path goes from the point straight to its second point, if the robot fits there; else by
// way of the centre, if it fits on the piece between; else it begins at the centre as before.

#include "wend/base/compiler.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// Where a path is to begin and to end.
struct PathEnds {
  Point start;  // grid coordinates, in the cell of the path's first point
  Point goal;   // the same of its last point
};

/// The path (not empty, not of poses) with these ends, for the disc around the robot; it is made of waypoints (over
/// cells, if it was made of cells), or the same path if neither end changes. On terrain or clearance costs it does not leave the cells of its steps.
/// O(cells passed at the ends, length of the path).
WEND_API Path with_ends(const Path& path, const PathEnds& ends, const FreeSpace& space,
                        Adjacency adjacency = Adjacency::edges);

}  // namespace wend
