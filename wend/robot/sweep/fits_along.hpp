#pragma once

// Where the robot of a FreeSpace can drive along lines and arcs, and where it can turn in place.
//
// Lines and arcs are in grid coordinates; arcs turn by at most 2 pi. They may touch the map's edge or leave
// the map. If the outside is free, it is not an obstacle. A robot fits nowhere along a way that contains NaN
// or infinity or leads far off the map (near_map()).
//
// - A point keeps out of the union of the obstacles and, unless `adjacency` is edges_and_corners, does
//   not pass between two that touch at a corner; point_sweep.hpp has the exact rules. Exact.
// - A disc keeps far enough from every obstacle, and from the map's edge if the outside is blocked, by
//   FreeSpace::far_enough(). Exact up to rounding.
// - A polygon overlaps no obstacle, nor the outside if that is blocked. Along lines this is exact up
//   to rounding. Where the polygon turns it is conservative: `true` is certain; `false` says that the
//   polygon, grown by `tolerance`, overlaps something on the way. No obstacle is missed, however thin.
//
//   const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});  // from corner to corner of cell (0,0)
//   if (wend::fits_along(space, arc)) length += arc.length;
//
// A disc along a line: O(rows that it passes + cells passed / 64). Others: O(1) for each piece that the
// clearance of a cell decides, else O(cells within the radius), for a polygon times its corners. Where a
// turning polygon nearly touches, this is repeated as often as the tolerance fits into the way of its
// farthest corner.

#include "wend/geometry/arc.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

struct SweepOptions {
  Adjacency adjacency = Adjacency::edges;  // for a point
  double tolerance = 0.01;                 // cells, greater than 0; for a polygon that turns
};

/// May the robot drive along the whole line, facing along it? A line of length 0 has no heading: a
/// polygon must fit at every heading.
bool fits_along(const FreeSpace& space, const Line& line, const SweepOptions& options = {});
bool fits_along(const FreeSpace& space, const Arc& arc, const SweepOptions& options = {});
/// May the robot make this turn? It is at most 2 pi in either direction.
bool fits_along(const FreeSpace& space, const TurnInPlace& turn, const SweepOptions& options = {});
bool fits_along(const FreeSpace& space, const Segment& segment, const SweepOptions& options = {});

/// The turn of a robot that faces along one line and then along the next one: the shorter way. For half a
/// turn both ways are as short: it is one that fits, if one does.
TurnInPlace turn_between(const FreeSpace& space, Point joint, double before, double after);

/// May the robot make that turn, and a little more? For code that changes paths: if their lines are
/// divided, rounding changes headings, and the turn still fits.
bool turns_with_margin(const FreeSpace& space, Point joint, double before, double after);

/// The same for every heading: a polygon counts as its circumscribed disc. For grid planners, which choose
/// no headings.
bool disc_fits_along(const FreeSpace& space, const Line& line,
                     Adjacency adjacency = Adjacency::edges);
bool disc_fits_along(const FreeSpace& space, const Arc& arc,
                     Adjacency adjacency = Adjacency::edges);

}  // namespace wend
