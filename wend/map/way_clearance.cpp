#include "wend/map/way_clearance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "wend/map/arc_clearance.hpp"
#include "wend/map/distance_field.hpp"

namespace wend {
namespace {

// Why the ends tell nearly everything. In half-cells from the first centre a straight way is (t, 0)
// and a diagonal one (t, t), t in [0, 2], and the borders of squares are odd. How far a square is
// off along one axis only grows or only falls with t, but for a stretch of width 2 where it is 0,
// and it changes between these only where t is odd: at t = 1. The distance is convex in t. So
//
// - on a straight way, where one axis does not change, an end is nearest;
// - on a diagonal way a point between the ends is nearest only where one axis falls as fast as the
//   other grows: where the way passes abreast of a corner (u, v) of the square with the way between
//   them, u + v = 2 t. u and v are odd, so t is 1 (0 and 2 are the ends): the middle, a corner of
//   the lattice, and the corner of the square lies on the antidiagonal through it, k cells to each
//   side, k >= 0. It is 8 k^2 squared half-cells from the middle, and its square
//   (2k+1)^2 + (2k-1)^2 = 8 k^2 + 2 from both ends (1 where k = 0, beside the step).
//
// So the middle can only be nearer than the ends if the nearer end has a clearance of 8 k^2 + 1 or
// 8 k^2 + 2 for some k: then two squares are to be looked at.
//
// To the map's edge, a straight line, an end is always nearest. Where the edge is nearer to that end
// than every obstacle is, its squared distance, (2n+1)^2, is one of these numbers or less than 8 k^2
// for the k of the obstacles, so that the ends tell as before.

/// The k for which a square may be nearer to the middle than an end that has this clearance.
int cells_from_middle(std::uint32_t nearer_end) {
  return static_cast<int>(std::sqrt(static_cast<double>(nearer_end - 1) / 8));
}

bool is_obstacle(const FreeSpace& space, Cell cell) {
  return space.contains(cell) && space.obstacles()[cell];
}

}  // namespace

std::uint32_t squared_half_cell_way_clearance(const FreeSpace& space, Cell from, Cell to) {
  assert(std::abs(from.x - to.x) <= 1 && std::abs(from.y - to.y) <= 1);
  const auto& clearance = space.squared_half_cell_clearance();
  const std::uint32_t at_ends = std::min(clearance[from], clearance[to]);
  if (from.x == to.x || from.y == to.y || at_ends == 0 || at_ends == kNoObstacle) return at_ends;
  const int k = cells_from_middle(at_ends);
  const auto in_the_middle = static_cast<std::uint32_t>(8 * k * k);
  if (at_ends > in_the_middle + 2) return at_ends;
  // The cells beside the step, and k cells farther to each side.
  const Cell aside{to.x - from.x, from.y - to.y};
  const bool near = is_obstacle(space, {to.x + k * aside.x, from.y + k * aside.y}) ||
                    is_obstacle(space, {from.x - k * aside.x, to.y - k * aside.y});
  return near ? in_the_middle : at_ends;
}

double way_clearance(const FreeSpace& space, Cell from, Cell to) {
  if (std::abs(from.x - to.x) <= 1 && std::abs(from.y - to.y) <= 1) {
    return distance_in_cells(squared_half_cell_way_clearance(space, from, to));
  }
  const double dx = static_cast<double>(to.x) - from.x;
  const double dy = static_cast<double>(to.y) - from.y;
  return arc_clearance(space, {pose_at(from, std::atan2(dy, dx)), std::hypot(dx, dy), 0});
}

}  // namespace wend
