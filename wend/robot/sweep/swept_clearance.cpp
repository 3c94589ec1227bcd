#include "wend/robot/sweep/swept_clearance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "wend/geometry/arc_distance.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/map/distance_field.hpp"
#include "wend/robot/near_map.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/point_sweep.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

// Why the ends of a way between neighbouring cells tell nearly everything about it. In half-cells
// from the first centre a straight way is (t, 0) and a diagonal one (t, t), t in [0, 2], and the
// borders of squares are odd. The distance of a square along one axis only grows or only falls with
// t, except for an interval of width 2 where it is 0, and it changes between these only where t is
// odd: at t = 1. The distance is convex in t. So
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
// 8 k^2 + 2 for some k: then two squares must be checked.
//
// To the map's edge, a straight line, an end is always nearest. Where the edge is nearer to that end
// than every obstacle is, its squared distance, (2n+1)^2, is one of these numbers or less than 8 k^2
// for the k of the obstacles, so that the ends tell as before.

/// The k for which a square may be nearer to the middle than an end that has this clearance.
int cells_from_middle(std::uint32_t nearer_end) {
  return static_cast<int>(std::sqrt(static_cast<double>(nearer_end - 1) / 8));
}

bool is_obstacle(const FreeSpace& space, Cell cell) {
  return space.contains(cell) && space.obstacles().blocked()[cell];
}

double squared_length(double x, double y) { return x * x + y * y; }

double squared_distance(Point a, Point b) { return squared_length(a.x - b.x, a.y - b.y); }

double squared_distance(Point point, Cell square) {
  return squared_length(std::max({square.x - point.x, point.x - square.x - 1, 0.0}),
                        std::max({square.y - point.y, point.y - square.y - 1, 0.0}));
}

/// The swept clearance of a line up to `reach`, or less, if it is at least `enough`.
double swept_clearance(const FreeSpace& space, const Line& line, double reach, double enough) {
  const Point middle = line.middle();
  const Cell cell = nearest_cell(space, middle);
  const Point centre = centre_of(cell);
  const double from_centre =
      std::sqrt(std::max(squared_distance(centre, line.from), squared_distance(centre, line.to)));
  constexpr double kEnough = 0.1;  // cells, to be on the safe side of rounding
  const double at_least = space.clearance(cell, reach + from_centre + kEnough) - from_centre;
  if (at_least >= enough) return std::min(at_least, reach);
  // Lines between neighbouring cells are shorter. A longer one is halved, so that the box around it
  // does not grow with the square of its length.
  constexpr double kShort = 4;
  const double half = std::sqrt(squared_distance(line.from, middle));
  if (2 * half > kShort) {
    const double first = swept_clearance(space, {line.from, middle}, reach, enough);
    if (first == 0) return 0;
    return std::min(first, swept_clearance(space, {middle, line.to}, reach, enough));
  }
  double least = std::min(reach, edge_clearance(space, line));
  Box box(line.from);
  box.include(line.to);
  any_obstacle(space, box.grown_by(reach), [&](Cell square) {
    const double near = least + half;  // the line's points are no farther than half from its middle
    if (squared_distance(middle, square) < near * near) {
      least = std::min(least, distance(line, square));
    }
    return least == 0;
  });
  return least;
}

/// Of an arc near the map.
double clearance_of(const FreeSpace& space, const Arc& arc) {
  const double length = std::abs(arc.length);
  constexpr double kLong = 64;  // the box around a long one grows with the square of its length
  if (length > kLong) {
    const auto halves = halves_of(arc);
    return std::min(clearance_of(space, halves[0]), clearance_of(space, halves[1]));
  }
  const int pieces = std::max(static_cast<int>(std::ceil(length)), 1);
  double least = std::numeric_limits<double>::infinity();
  Box box(arc.from.point());
  for (int i = 0; i <= pieces; ++i) {
    const Point point = point_on(arc, arc.length * i / pieces);
    const Cell cell = nearest_cell(space, point);
    least = std::min(least, space.clearance(cell) + distance(point, centre_of(cell)));
    box.include(point);
  }
  if (std::isinf(least)) return least;
  least = std::min(least, edge_clearance(space, arc));
  const Point middle = point_on(arc, arc.length / 2);
  any_obstacle(space, box.grown_by(least + length / pieces / 2), [&](Cell square) {
    if (distance(middle, square) - length / 2 < least) {
      least = std::min(least, distance(arc, square));
    }
    return false;
  });
  return least;
}

}  // namespace

double arc_clearance(const FreeSpace& space, const Arc& arc) {
  return near_map(space, arc) ? clearance_of(space, arc) : 0;
}

std::uint32_t squared_half_cell_way_clearance(const FreeSpace& space, Cell from, Cell to) {
  assert(std::abs(from.x - to.x) <= 1 && std::abs(from.y - to.y) <= 1);
  const std::uint32_t at_ends = std::min(space.squared_half_cell_clearance(from, kNoObstacle),
                                         space.squared_half_cell_clearance(to, kNoObstacle));
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
  if (!space.contains(from) || !space.contains(to)) return 0;
  if (std::abs(from.x - to.x) <= 1 && std::abs(from.y - to.y) <= 1) {
    return distance_in_cells(squared_half_cell_way_clearance(space, from, to));
  }
  const double dx = static_cast<double>(to.x) - from.x;
  const double dy = static_cast<double>(to.y) - from.y;
  return arc_clearance(space, {pose_at(from, arc_tangent(dy, dx)), hypotenuse(dx, dy), 0});
}

std::optional<double> room_along(const FreeSpace& space, const Line& line, Adjacency adjacency) {
  if (!near_map(space, line)) return std::nullopt;
  const double radius = space.radius_in_cells();
  const double clearance = swept_clearance(space, line, radius + kMostRoom, radius + kMostRoom / 2);
  if (keeps_distance(space, clearance)) return std::max(clearance - radius, 0.0);
  if (radius > 0 || !disc_fits_along(space, line, adjacency)) return std::nullopt;
  if (adjacency == Adjacency::edges && (in_gap(space, line.from) || in_gap(space, line.to))) {
    return std::nullopt;
  }
  return 0;
}

}  // namespace wend
