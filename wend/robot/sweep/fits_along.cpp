#include "wend/robot/sweep/fits_along.hpp"

#include <cmath>
#include <optional>

#include "wend/geometry/angle.hpp"
#include "wend/robot/near_map.hpp"
#include "wend/robot/sweep/disc_rows.hpp"
#include "wend/robot/sweep/disc_sweep.hpp"
#include "wend/robot/sweep/point_sweep.hpp"
#include "wend/robot/sweep/polygon_sweep.hpp"

namespace wend {

bool disc_fits_along(const FreeSpace& space, const Line& line, Adjacency adjacency) {
  if (space.is_point()) return PointSweep(space, line.from, adjacency).go_to(line.to);
  if (!near_map(space, line)) return false;
  const DiscSweep sweep(space);
  if (!sweep.fits_at(line.from) || !sweep.fits_at(line.to)) return false;
  const std::optional<bool> fits = disc_fits_by_rows(space, line);
  return fits ? *fits : sweep.fits(line);
}

bool disc_fits_along(const FreeSpace& space, const Arc& arc, Adjacency adjacency) {
  if (space.is_point()) return PointSweep(space, arc.from.point(), adjacency).go_along(arc);
  if (!near_map(space, arc)) return false;
  const DiscSweep sweep(space);
  return sweep.fits_at(arc.from.point()) && sweep.fits(arc);
}

bool fits_along(const FreeSpace& space, const Line& line, const SweepOptions& options) {
  if (!space.outline() || line.length() == 0) {
    return disc_fits_along(space, line, options.adjacency);
  }
  return near_map(space, line) && PolygonSweep(space, options.tolerance).fits(line);
}

bool fits_along(const FreeSpace& space, const Arc& arc, const SweepOptions& options) {
  // If the disc fits, even touching something, so does its polygon. The polygon's sweep alone does not
  // see that within its tolerance.
  if (disc_fits_along(space, arc, options.adjacency)) return true;
  return space.outline() && near_map(space, arc) &&
         PolygonSweep(space, options.tolerance).fits(arc);
}

bool fits_along(const FreeSpace& space, const TurnInPlace& turn, const SweepOptions& options) {
  if (!near_map(space, turn)) return false;
  const Point point = turn.from.point();
  if (disc_fits_along(space, Line{point, point}, options.adjacency)) return true;
  return space.outline() && PolygonSweep(space, options.tolerance).fits(turn);
}

TurnInPlace turn_between(const FreeSpace& space, Point joint, double before, double after) {
  const TurnInPlace turn{{joint.x, joint.y, before}, normalized_angle(after - before)};
  constexpr double kRounding = 1e-9;
  if (std::abs(turn.angle) < kPi - kRounding || fits_along(space, turn)) return turn;
  const TurnInPlace other{turn.from, turn.angle - std::copysign(2 * kPi, turn.angle)};
  return fits_along(space, other) ? other : turn;
}

bool turns_with_margin(const FreeSpace& space, Point joint, double before, double after) {
  constexpr double kMargin = 1e-7;  // radians
  TurnInPlace turn = turn_between(space, joint, before, after);
  if (!fits_along(space, turn)) return false;
  const double margin = std::copysign(kMargin, turn.angle);
  turn.from.heading -= margin;
  turn.angle += 2 * margin;
  return fits_along(space, turn);
}

bool fits_along(const FreeSpace& space, const Segment& segment, const SweepOptions& options) {
  if (!near_map(space, segment)) return false;
  if (disc_fits_along(space, way_of_base(segment), options.adjacency)) return true;
  return space.outline() && PolygonSweep(space, options.tolerance).fits(segment);
}

}  // namespace wend
