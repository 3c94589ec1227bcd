#include "wend/map/line_room.hpp"

#include <algorithm>
#include <cmath>

#include "wend/map/arc_clearance.hpp"
#include "wend/map/map_edge.hpp"
#include "wend/map/obstacles_near.hpp"
#include "wend/map/point_sweep.hpp"

namespace wend {
namespace {

/// Lines between neighbouring cells are shorter. A longer one is halved, so that the box around it
/// does not grow with the square of its length.
constexpr double kShort = 4;

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
  const double at_least = space.clearance(cell) - from_centre;
  if (at_least >= enough) return std::min(at_least, reach);
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

}  // namespace

std::optional<double> room_along(const FreeSpace& space, const Line& line, Adjacency adjacency) {
  const double radius = space.radius_in_cells();
  const double clearance = swept_clearance(space, line, radius + kMostRoom, radius + kMostRoom / 2);
  if (clearance > 0 && space.far_enough(4 * clearance * clearance)) {
    return std::max(clearance - radius, 0.0);
  }
  if (radius > 0 || !fits_along(space, line, adjacency)) return std::nullopt;
  if (adjacency == Adjacency::edges && (in_gap(space, line.from) || in_gap(space, line.to))) {
    return std::nullopt;
  }
  return 0;
}

}  // namespace wend
