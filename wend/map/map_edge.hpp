#pragma once

// How far from the map's edge a robot's centre stays on a line or an arc, in grid coordinates.

#include <algorithm>
#include <limits>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/line.hpp"
#include "wend/map/free_space.hpp"

namespace wend {

/// The least distance from the edge, in cells, exact up to rounding; negative where the point, or a
/// part of the way, lies outside the map. O(1).
double distance_inside(const FreeSpace& space, Point point);
double distance_inside(const FreeSpace& space, const Line& line);
double distance_inside(const FreeSpace& space, const Arc& arc);

/// What the edge adds to the clearance of a way: its distance, 0 outside the map; infinite if the
/// robot's disc may hang over the edge.
template <class Way>
double edge_clearance(const FreeSpace& space, const Way& way) {
  if (space.outside() == OutsidePolicy::free) return std::numeric_limits<double>::infinity();
  return std::max(distance_inside(space, way), 0.0);
}

}  // namespace wend
