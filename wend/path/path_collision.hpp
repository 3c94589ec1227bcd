#pragma once

// Where a path first collides: for the disc or the polygon of the space's robot, swept along lines
// and arcs, or for a point.
//
//   if (const auto collision = wend::first_collision(path, space)) {
//     report(wend::describe(collision->kind));
//   }
//
// A disc keeps its radius from every closed obstacle square; touching is allowed. A point does not
// enter the union of the obstacles (edges and corners may be touched), and does not pass between
// two obstacles that touch at a corner, unless `adjacency` is edges_and_corners. A polygon overlaps no
// obstacle: it faces along each line of a path and turns in place, the shorter way, where the next one
// leads elsewhere (half a turn: either way); along arcs it has the heading that they say. Where a path only stands and has no
// headings, a polygon has to fit at every one. The base point stays on the map, and
// the shape too if the outside is blocked. Exact up to rounding, but where a polygon turns:
// fits_along.hpp says how conservative that is.
//
// The time depends on the length of the way on the map: a way off it is not swept. A path whose numbers are of
// no use (fault_of(), path_fault.hpp) leaves the map at the last point before these.

#include <cstddef>
#include <optional>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// How a path collides.
enum class CollisionKind {
  outside,    // the robot's base point leaves the map; its shape does, and the outside is blocked
  obstacle,   // its base point enters an obstacle
  too_close,  // its disc does
  squeezed,   // a point passes between two obstacles that touch at a corner
  overlaps,   // its polygon overlaps an obstacle
};

/// "leaves the map", "enters an obstacle", "comes closer to an obstacle than the robot's radius",
/// "overlaps an obstacle with its footprint", "passes between two obstacles that touch at a corner".
WEND_API std::string_view describe(CollisionKind kind);

/// The first collision of a path.
struct PathCollision {
  CollisionKind kind = CollisionKind::obstacle;  // what happens there
  std::size_t piece = 0;                         // index in Path::arcs(); 0 for a path of one point
  double along = 0;              // cells, from the path's start; within 1e-6 of the first contact
  Point point;                   // grid coordinates, of the robot's base point
  std::optional<Cell> obstacle;  // unset for a collision with the map's edge
};

/// Nothing if the whole path is free, and for an empty one. O(length on the map) far from obstacles.
WEND_API std::optional<PathCollision> first_collision(const Path& path, const FreeSpace& space,
                                                      Adjacency adjacency = Adjacency::edges);

/// Where the robot's base point first leaves the map, whatever else is in its way; nothing if it does not. O(n).
WEND_API std::optional<PathCollision> first_exit(const Path& path, const FreeSpace& space);

}  // namespace wend
