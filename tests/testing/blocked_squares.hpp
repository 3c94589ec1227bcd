#pragma once

// Clearance by brute force: the least distance to all the squares that count as blocked, to check
// distance fields and sweeps against.

#include <algorithm>

#include "conformance/reference.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::test {

/// The least that `distance` says of any obstacle and, if the outside is blocked, of any cell around
/// the map. `from` is a point of what is measured: outside the map it has no clearance, and what
/// leaves the map crosses one of the cells around it.
template <class Distance>
double least_distance_to_blocked(const FreeSpace& space, Point from, Distance&& distance) {
  const bool edge_counts = space.outside() == OutsidePolicy::blocked;
  if (edge_counts &&
      (from.x < 0 || from.x > space.width() || from.y < 0 || from.y > space.height()))
    return 0;
  double least = kInfinite;
  for (int y = -1; y <= space.height(); ++y) {
    for (int x = -1; x <= space.width(); ++x) {
      const Cell cell{x, y};
      const bool blocked = space.contains(cell) ? space.obstacles().blocked()[cell] : edge_counts;
      if (blocked) least = std::min(least, distance(cell));
    }
  }
  return least;
}

/// From a point.
inline double clearance_at(const FreeSpace& space, Point point) {
  return least_distance_to_blocked(
      space, point, [&](Cell cell) { return distance_to_square(point.x, point.y, cell); });
}

}  // namespace wend::test
