#include "wend/robot/sweep/polygon_sweep.hpp"

#include <algorithm>
#include <cassert>

#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

double turn_of(const Arc& arc) { return arc.turn(); }
double turn_of(const TurnInPlace& turn) { return turn.angle; }
double turn_of(const Segment& segment) { return segment.turn; }

Pose middle_of(const Arc& arc) { return pose_on(arc, arc.length / 2); }
Pose middle_of(const TurnInPlace& turn) { return pose_on(turn, turn.angle / 2); }
Pose middle_of(const Segment& segment) { return pose_on(segment, 0.5); }

}  // namespace

PolygonSweep::PolygonSweep(const FreeSpace& space, double tolerance)
    : space_(space),
      outline_(*space.outline()),
      circumscribed_(space.radius_in_cells()),
      inscribed_(space.inscribed_radius_in_cells()),
      tolerance_(tolerance) {
  assert(tolerance > 0);
}

/// The verdict of the two discs for a base point that stays within half_length of `middle` and is at
/// `middle` at least once.
PolygonSweep::Verdict PolygonSweep::disc_verdict(Point middle, double half_length) const {
  const Cell cell = nearest_cell(space_, middle);
  const double clearance = near_clearance(space_, cell);
  const double from_centre = distance(middle, centre_of(cell));
  if (keeps_distance(space_, clearance - from_centre - half_length)) return Verdict::fits;
  if (clearance + from_centre < inscribed_ - kOverlapTolerance) return Verdict::blocked;
  return Verdict::open;
}

bool PolygonSweep::stays_inside(const Box& box, double margin) const {
  if (space_.outside() == OutsidePolicy::free) return true;
  const double least = margin - kOverlapTolerance;
  return distance_inside(space_, box.low) >= least && distance_inside(space_, box.high) >= least;
}

std::optional<BlockReason> PolygonSweep::why_blocked(const Pose& pose) const {
  const Verdict verdict = disc_verdict(pose.point(), 0);
  if (verdict == Verdict::fits) return std::nullopt;
  const PlacedPolygon robot(outline_, pose);
  if (!stays_inside(robot.box(), 0)) return BlockReason::leaves;
  const bool overlaps =
      any_obstacle(space_, robot.box(), [&](Cell square) { return robot.overlaps(square); });
  return overlaps ? std::optional(BlockReason::overlaps) : std::nullopt;
}

bool PolygonSweep::fits(const Line& line) const { return fits_facing(line, line.heading()); }

/// For a polygon that moves without turning, PlacedPolygon::overlaps_along() is exact.
bool PolygonSweep::fits_facing(const Line& line, double heading) const {
  const Point middle = line.middle();
  const Verdict verdict = disc_verdict(middle, line.length() / 2);
  if (verdict != Verdict::open) return verdict == Verdict::fits;
  constexpr double kShort = 2;
  if (line.length() > std::max(kShort, circumscribed_)) {
    const auto halves = halves_of(line);
    return fits_facing(halves[0], heading) && fits_facing(halves[1], heading);
  }
  const PlacedPolygon robot(outline_, {line.from.x, line.from.y, heading});
  const Point by{line.to.x - line.from.x, line.to.y - line.from.y};
  const Box& begin = robot.box();
  Box box = begin;
  box.include({begin.low.x + by.x, begin.low.y + by.y});
  box.include({begin.high.x + by.x, begin.high.y + by.y});
  if (!stays_inside(box, 0)) return false;
  return !any_obstacle(space_, box, [&](Cell square) { return robot.overlaps_along(by, square); });
}

/// The verdict for poses at which each point of the polygon is within `reach` of its place at `middle`.
PolygonSweep::Verdict PolygonSweep::verdict_near(const Pose& middle, double reach) const {
  const PlacedPolygon robot(outline_, middle);
  if (!stays_inside(robot.box(), 0)) return Verdict::blocked;
  bool blocked = false;
  bool near = !stays_inside(robot.box(), reach);
  any_obstacle(space_, robot.box().grown_by(reach), [&](Cell square) {
    blocked = robot.overlaps(square);
    near = near || robot.distance_to(square) < reach;
    return blocked;
  });
  if (blocked) return Verdict::blocked;
  return near ? Verdict::open : Verdict::fits;
}

/// Halves the way until the polygon at the middle of a piece is farther from everything than any of its
/// points moves on the piece, or until that movement is less than the tolerance.
template <class Way>
bool PolygonSweep::turning_fits(const Way& way) const {
  const Pose middle = middle_of(way);
  const double half_length = length_of(way) / 2;
  Verdict verdict = disc_verdict(middle.point(), half_length);
  if (verdict != Verdict::open) return verdict == Verdict::fits;
  const double reach = half_length + circumscribed_ * std::abs(turn_of(way)) / 2;
  verdict = verdict_near(middle, reach);
  if (verdict != Verdict::open) return verdict == Verdict::fits;
  if (reach <= tolerance_) return false;
  const auto halves = halves_of(way);
  return turning_fits(halves[0]) && turning_fits(halves[1]);
}

/// Does the polygon turn on the way, but for rounding?
template <class Way>
bool PolygonSweep::turns(const Way& way) const {
  return std::abs(turn_of(way)) * (circumscribed_ + length_of(way)) > kOverlapTolerance;
}

bool PolygonSweep::fits(const Arc& arc) const {
  if (arc.length == 0) return fits_at(arc.from);
  if (turns(arc)) return turning_fits(arc);
  return fits_facing({arc.from.point(), point_on(arc, arc.length)}, arc.from.heading);
}

bool PolygonSweep::fits(const TurnInPlace& turn) const {
  return turns(turn) ? turning_fits(turn) : fits_at(turn.from);
}

bool PolygonSweep::fits(const Segment& segment) const {
  if (turns(segment)) return turning_fits(segment);
  if (segment.length == 0) return fits_at(segment.from);
  return fits_facing({segment.from.point(), end_of(segment).point()}, segment.from.heading);
}

}  // namespace wend
