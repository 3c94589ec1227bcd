#pragma once

// The first collision of a path: of the robot's disc, swept exactly along lines and arcs, or of a
// point.
//
//   if (const auto collision = wend::first_collision(path, space)) {
//     report(wend::describe(collision->kind));
//   }
//
// A disc keeps its radius from every closed obstacle square; touching is allowed. A point does not
// enter the union of the obstacles (edges and corners may be touched), and does not pass between
// two obstacles that touch at a corner, unless `adjacency` is edges_and_corners. The centre stays
// on the map, and the disc too if the outside is blocked.

#include <cstddef>
#include <optional>
#include <string_view>

#include "wend/map/connected_components.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

enum class CollisionKind {
  outside,    // the robot's centre leaves the map, or its disc does and the outside is blocked
  obstacle,   // its centre enters an obstacle
  too_close,  // its disc does
  squeezed,   // a point passes between two obstacles that touch at a corner
};

/// "leaves the map", "enters an obstacle", "comes closer to an obstacle than the robot's radius",
/// "squeezes between two obstacles that touch at a corner".
std::string_view describe(CollisionKind kind);

struct PathCollision {
  CollisionKind kind = CollisionKind::obstacle;
  std::size_t piece = 0;         // index in Path::arcs(); 0 for a path of one point
  double along = 0;              // cells, from the path's start; within 1e-6 of the first contact
  Point point;                   // grid coordinates: the robot's centre
  std::optional<Cell> obstacle;  // unset for a collision with the map's edge
};

/// Nothing if the whole path (not empty) is free. O(length) far from obstacles.
std::optional<PathCollision> first_collision(const Path& path, const FreeSpace& space,
                                             Adjacency adjacency = Adjacency::edges);

}  // namespace wend
