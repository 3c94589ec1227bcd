#pragma once

// HybridGoal: where a path of a hybrid A* search may end: a pose, a point with any heading, and what lies within the
// tolerances of the query's goal.

#include <cmath>
#include <cstddef>

#include "wend/planner/plan.hpp"
#include "wend/space/se2/motion.hpp"

namespace wend {

struct HybridGoal {
  Pose pose;                 // a place where the robot fits; its heading counts unless any_heading
  bool any_heading = false;  // may a path end with any heading there?
  Goal asked{Point{}};       // what the query says
  std::size_t index = 0;     // of the query's goals

  /// Does a path have to end with exactly this pose?
  bool wants_heading() const {
    return !any_heading && asked.tolerance == 0 && asked.heading_tolerance == 0;
  }

  /// Is a pose within the tolerances? Without tolerances, none is.
  bool accepts(const Pose& at) const {
    if (!asked.reaches(at.point())) return false;
    if (asked.reaches_heading(at.heading)) return true;
    constexpr double kSame = 1e-9;
    return asked.heading && std::abs(wrapped_angle(at.heading - *asked.heading)) < kSame;
  }
};

}  // namespace wend
