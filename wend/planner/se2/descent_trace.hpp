#pragma once

// DescentTrace: the way along which a CoarseCostField falls from a point on, for long steps of a search. The field knows
// only a robot that can turn on the spot; in narrow places the poses of the trace are moved and turned to where the
// robot has more room.

#include <cstddef>
#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/space/se2/coarse_cost_field.hpp"
#include "wend/space/se2/motion_check.hpp"

namespace wend {

class DescentTrace {
 public:
  /// Points at a distance of `step` cells. Check and field must outlive the trace.
  DescentTrace(const MotionCheck& check, CoarseCostField& field, double step)
      : check_(check), field_(field), step_(step) {}

  /// Follows the descent from a point, and settles the field on the way; returns what is left of the cost at the last
  /// point.
  double follow(Point from);

  std::size_t size() const { return points_.size(); }

  /// Has the robot less room there than before and behind, and hardly any?
  bool is_narrow_at(std::size_t i) const;

  /// The pose at a point, heading along the trace; where the robot has hardly any room, in the middle, and turned to
  /// where there is room ahead and behind.
  Pose pose(std::size_t i) const;

 private:
  struct TracePoint {
    Point point;
    double room;  // beside the robot, in cells
  };

  double room_at(Point point) const;
  Pose centred(const Pose& pose) const;
  double heading_with_most_room(const Pose& pose) const;

  const MotionCheck& check_;
  CoarseCostField& field_;
  double step_;
  std::vector<TracePoint> points_;
};

}  // namespace wend
