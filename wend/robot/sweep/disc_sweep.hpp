#pragma once

// DiscSweep: moves the (circumscribed) disc of a robot along lines and arcs, exactly.
//
// Clearance changes by no more than the distance moved, along an arc or between a point and the centre
// of a cell. So the exact clearance of one cell bounds the clearance of all points near it.

#include <algorithm>

#include "wend/geometry/arc_distance.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {

class DiscSweep {
 public:
  /// The space must outlive the sweep.
  explicit DiscSweep(const FreeSpace& space) : space_(space), radius_(space.radius_in_cells()) {}

  bool fits_at(Point point) const {
    const Cell cell = nearest_cell(space_, point);
    if (point == centre_of(cell)) return space_.passable(cell);
    const double clearance = near_clearance(space_, cell);
    const double from_centre = distance(point, centre_of(cell));
    if (far_enough(clearance - from_centre)) return true;
    if (!far_enough(clearance + from_centre)) return false;
    if (!far_enough(edge_clearance(space_, point))) return false;
    return !any_obstacle(space_, Box(point).grown_by(radius_),
                         [&](Cell square) { return !far_enough(distance(point, square)); });
  }

  /// Requires that its first point fits.
  template <class Way>
  bool fits(const Way& way) const {
    if (turns_far(way)) return halves_fit(way);
    const SweptPiece piece(way);
    const Cell cell = nearest_cell(space_, piece.middle);
    const Point centre = centre_of(cell);
    const double clearance = near_clearance(space_, cell);
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

  bool far_enough(double cells) const { return keeps_distance(space_, cells); }

  const FreeSpace& space_;
  double radius_;
};

}  // namespace wend
