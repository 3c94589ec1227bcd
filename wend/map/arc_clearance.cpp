#include "wend/map/arc_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wend/geometry/arc_distance.hpp"
#include "wend/map/map_edge.hpp"
#include "wend/map/obstacles_near.hpp"
#include "wend/map/point_sweep.hpp"
#include "wend/map/swept_piece.hpp"

namespace wend {
namespace {

// Along an arc clearance changes by no more than the way, and so between a point and the centre of
// a cell. So the clearance of one cell, which is exact, tells much of all points near it.

/// Moves the disc of the space's robot along arcs and lines.
class Sweep {
 public:
  explicit Sweep(const FreeSpace& space) : space_(space), radius_(space.radius_in_cells()) {}

  bool fits_at(Point point) const {
    const Cell cell = nearest_cell(space_, point);
    const double clearance = space_.clearance(cell);
    const double from_centre = distance(point, centre_of(cell));
    if (far_enough(clearance - from_centre)) return true;
    if (!far_enough(clearance + from_centre)) return false;
    if (!far_enough(edge_clearance(space_, point))) return false;
    return !any_obstacle(space_, Box(point).grown_by(radius_),
                         [&](Cell square) { return !far_enough(distance(point, square)); });
  }

  /// Its first point fits.
  template <class Way>
  bool fits(const Way& way) const {
    if (turns_far(way)) return halves_fit(way);
    const SweptPiece piece(way);
    const Cell cell = nearest_cell(space_, piece.middle);
    const Point centre = centre_of(cell);
    const double clearance = space_.clearance(cell);
    if (far_enough(clearance - piece.farthest_from(centre))) return true;
    const double nearer_end = std::min(distance(centre, piece.from), distance(centre, piece.to));
    if (!far_enough(clearance + nearer_end)) return false;
    constexpr double kShort = 2;
    if (length_of(way) > std::max(kShort, radius_)) return halves_fit(way);
    if (!far_enough(edge_clearance(space_, way))) return false;
    return !any_obstacle(space_, piece.box().grown_by(radius_), [&](Cell square) {
      if (far_enough(distance(piece.middle, square) - piece.half_chord)) return false;
      return !far_enough(distance(piece.to, square)) || !far_enough(distance(way, square));
    });
  }

 private:
  template <class Way>
  bool halves_fit(const Way& way) const {
    const auto halves = halves_of(way);
    return fits(halves[0]) && fits(halves[1]);
  }

  bool far_enough(double cells) const { return cells > 0 && space_.far_enough(4 * cells * cells); }

  const FreeSpace& space_;
  double radius_;
};

}  // namespace

double arc_clearance(const FreeSpace& space, const Arc& arc) {
  const double length = std::abs(arc.length);
  constexpr double kLong = 64;  // the box around a long one grows with the square of its length
  if (length > kLong) {
    const auto halves = halves_of(arc);
    return std::min(arc_clearance(space, halves[0]), arc_clearance(space, halves[1]));
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

bool fits_along(const FreeSpace& space, const Arc& arc, Adjacency adjacency) {
  if (space.radius_in_cells() == 0) {
    return PointSweep(space, arc.from.point(), adjacency).go_along(arc);
  }
  const Sweep sweep(space);
  return sweep.fits_at(arc.from.point()) && sweep.fits(arc);
}

bool fits_along(const FreeSpace& space, const Line& line, Adjacency adjacency) {
  if (space.radius_in_cells() == 0) {
    return PointSweep(space, line.from, adjacency).go_to(line.to);
  }
  const Sweep sweep(space);
  return sweep.fits_at(line.from) && sweep.fits(line);
}

}  // namespace wend
