#pragma once

// How far a lattice is from what was asked for.

#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/planner/plan.hpp"

namespace wend {

inline SnappingError snapping_error_between(const Goal& asked, const Pose& taken) {
  const double turn = asked.heading ? normalized_angle(*asked.heading - taken.heading) : 0;
  return {distance(asked.point, taken.point()), std::abs(turn)};
}

}  // namespace wend
