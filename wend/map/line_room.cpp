#include "wend/map/line_room.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/arc_distance.hpp"
#include "wend/map/arc_clearance.hpp"
#include "wend/map/obstacles_near.hpp"
#include "wend/map/point_sweep.hpp"

namespace wend {
namespace {

/// Lines between neighbouring cells are shorter. A longer one is halved, so that the box around it
/// does not grow with the square of its length.
constexpr double kShort = 4;

/// The swept clearance of a line up to `reach`, or less, if it is at least `enough`.
double swept_clearance(const FreeSpace& space, const Line& line, double reach, double enough) {
  const Point middle = line.middle();
  const Cell cell = nearest_cell(space, middle);
  const Point centre = centre_of(cell);
  const double from_centre = std::max(distance(centre, line.from), distance(centre, line.to));
  const double at_least = space.clearance(cell) - from_centre;
  if (at_least >= enough) return std::min(at_least, reach);
  const double half = line.length() / 2;
  if (2 * half > kShort) {
    const double first = swept_clearance(space, {line.from, middle}, reach, enough);
    if (first == 0) return 0;
    return std::min(first, swept_clearance(space, {middle, line.to}, reach, enough));
  }
  double least = reach;
  Box box(line.from);
  box.include(line.to);
  any_obstacle(space, box.grown_by(reach), [&](Cell square) {
    if (distance(middle, square) - half < least) least = std::min(least, distance(line, square));
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
