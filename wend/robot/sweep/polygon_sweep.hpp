#pragma once

// PolygonSweep: where a robot's polygon fits, and along which lines, arcs and turns in place it can
// move. fits_along.hpp says what is exact.
//
// The clearance of the nearest cell decides far from obstacles (the circumscribed disc fits) and inside
// them (the inscribed disc does not fit). Otherwise the polygon itself is compared with nearby squares.

#include <cmath>
#include <optional>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"

namespace wend {

class PolygonSweep {
 public:
  /// The space's robot must be a polygon. The space must outlive the sweep.
  explicit PolygonSweep(const FreeSpace& space, double tolerance = SweepOptions{}.tolerance);

  /// Why the polygon does not fit at a pose whose base point is on the map: overlaps or leaves.
  std::optional<BlockReason> why_blocked(const Pose& pose) const;

  bool fits_at(const Pose& pose) const { return !why_blocked(pose); }

  /// Fits facing along the line? Its length must not be 0.
  bool fits(const Line& line) const;
  bool fits(const Arc& arc) const;
  bool fits(const TurnInPlace& turn) const;
  bool fits(const Segment& segment) const;

 private:
  enum class Verdict { fits, blocked, open };

  Verdict disc_verdict(Point middle, double half_length) const;
  bool fits_facing(const Line& line, double heading) const;
  template <class Way>
  bool turns(const Way& way) const;
  Verdict verdict_near(const Pose& middle, double reach) const;
  bool stays_inside(const Box& box, double margin) const;

  template <class Way>
  bool turning_fits(const Way& way) const;

  const FreeSpace& space_;
  const Polygon& outline_;
  double circumscribed_;
  double inscribed_;
  double tolerance_;
};

}  // namespace wend
