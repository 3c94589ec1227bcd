#include "wend/map/way_clearance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

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

/// The k for which a square may be nearer to the middle than an end that has this clearance.
int cells_from_middle(std::uint32_t nearer_end) {
  return static_cast<int>(std::sqrt(static_cast<double>(nearer_end - 1) / 8));
}

bool is_obstacle(const FreeSpace& space, Cell cell) {
  return space.contains(cell) && space.obstacles()[cell];
}

/// Between a closed interval and a number.
double distance_to_interval(double low, double high, double value) {
  return std::max({low - value, value - high, 0.0});
}

/// From a point to a closed square.
double squared_distance(Point point, Cell square) {
  const double x = distance_to_interval(square.x, square.x + 1.0, point.x);
  const double y = distance_to_interval(square.y, square.y + 1.0, point.y);
  return x * x + y * y;
}

/// A way from one point to another one.
struct Way {
  Point from;
  Point along;  // to the other end
  double squared_length;

  Way(Cell first, Cell last)
      : from(centre_of(first)),
        along{static_cast<double>(last.x) - first.x, static_cast<double>(last.y) - first.y},
        squared_length(along.x * along.x + along.y * along.y) {}

  Point at(double share) const { return {from.x + share * along.x, from.y + share * along.y}; }

  double squared_distance_to(Point point) const {
    const double dx = point.x - from.x;
    const double dy = point.y - from.y;
    const double share = std::clamp((dx * along.x + dy * along.y) / squared_length, 0.0, 1.0);
    const Point nearest = at(share);
    return (point.x - nearest.x) * (point.x - nearest.x) +
           (point.y - nearest.y) * (point.y - nearest.y);
  }

  /// Does it cross the closed square? (The stretch of it that is inside both of its slabs.)
  bool crosses(Cell square) const {
    double first = 0;
    double last = 1;
    const auto cut = [&](double start, double slope, double low) {
      if (slope == 0) {
        if (start < low || start > low + 1) last = -1;
        return;
      }
      const double one = (low - start) / slope;
      const double other = (low + 1 - start) / slope;
      first = std::max(first, std::min(one, other));
      last = std::min(last, std::max(one, other));
    };
    cut(from.x, along.x, square.x);
    cut(from.y, along.y, square.y);
    return first <= last;
  }

  /// An end of the way or a corner of the square is where they are nearest, unless they meet.
  double squared_distance_to(Cell square) const {
    if (crosses(square)) return 0;
    double least = std::min(squared_distance(from, square), squared_distance(at(1), square));
    for (const int x : {square.x, square.x + 1}) {
      for (const int y : {square.y, square.y + 1}) {
        const Point corner{static_cast<double>(x), static_cast<double>(y)};
        least = std::min(least, squared_distance_to(corner));
      }
    }
    return least;
  }
};

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
  const double at_ends = std::min(space.clearance(from), space.clearance(to));
  const int size = std::max(space.width(), space.height());
  const int reach = static_cast<int>(std::min<double>(std::ceil(at_ends), size));
  const Cell first{std::max(std::min(from.x, to.x) - reach, 0),
                   std::max(std::min(from.y, to.y) - reach, 0)};
  const Cell last{std::min(std::max(from.x, to.x) + reach, space.width() - 1),
                  std::min(std::max(from.y, to.y) + reach, space.height() - 1)};
  const Way way(from, to);
  double least = at_ends * at_ends;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      if (space.obstacles()[{x, y}]) least = std::min(least, way.squared_distance_to(Cell{x, y}));
    }
  }
  return std::sqrt(least);
}

}  // namespace wend
