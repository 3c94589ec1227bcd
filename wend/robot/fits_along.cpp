#include "wend/robot/fits_along.hpp"

#include "wend/robot/disc_sweep.hpp"
#include "wend/robot/point_sweep.hpp"
#include "wend/robot/polygon_sweep.hpp"

namespace wend {

bool disc_fits_along(const FreeSpace& space, const Line& line, Adjacency adjacency) {
  if (space.is_point()) return PointSweep(space, line.from, adjacency).go_to(line.to);
  const DiscSweep sweep(space);
  return sweep.fits_at(line.from) && sweep.fits(line);
}

bool disc_fits_along(const FreeSpace& space, const Arc& arc, Adjacency adjacency) {
  if (space.is_point()) return PointSweep(space, arc.from.point(), adjacency).go_along(arc);
  const DiscSweep sweep(space);
  return sweep.fits_at(arc.from.point()) && sweep.fits(arc);
}

bool fits_along(const FreeSpace& space, const Line& line, const SweepOptions& options) {
  if (!space.outline() || line.length() == 0) {
    return disc_fits_along(space, line, options.adjacency);
  }
  return PolygonSweep(space, options.tolerance).fits(line);
}

bool fits_along(const FreeSpace& space, const Arc& arc, const SweepOptions& options) {
  // If the disc fits, even touching something, so does its polygon. The polygon's sweep alone does not
  // see that within its tolerance.
  if (disc_fits_along(space, arc, options.adjacency)) return true;
  return space.outline() && PolygonSweep(space, options.tolerance).fits(arc);
}

bool fits_along(const FreeSpace& space, const TurnInPlace& turn, const SweepOptions& options) {
  const Point point = turn.from.point();
  if (disc_fits_along(space, Line{point, point}, options.adjacency)) return true;
  return space.outline() && PolygonSweep(space, options.tolerance).fits(turn);
}

bool fits_along(const FreeSpace& space, const Segment& segment, const SweepOptions& options) {
  if (disc_fits_along(space, way_of_base(segment), options.adjacency)) return true;
  return space.outline() && PolygonSweep(space, options.tolerance).fits(segment);
}

}  // namespace wend
