#pragma once

// The ends of a query on a lattice: which goals a planner can take, and how far the lattice is from what was
// asked for.

#include <cmath>
#include <optional>

#include "wend/base/status.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/planner/plan.hpp"

namespace wend {

/// Calls take(goal) for every goal, which returns why it cannot be taken. If none can: the reason of the
/// first.
template <class Take>
std::optional<Status> take_goals(const Query& query, Take&& take) {
  std::optional<Status> why_none;
  bool any = false;
  for (const Goal& goal : query.goals) {
    const std::optional<Status> failed = take(goal);
    any = any || !failed;
    if (failed && !why_none) why_none = failed;
  }
  return any ? std::nullopt : why_none;
}

/// Calls visit(index) for each of `count` headings at which a goal lets a path end; `nearest` is the one that
/// stands for its heading.
template <class RadiansOf, class Visit>
void for_each_heading(const Goal& goal, int nearest, int count, RadiansOf&& radians_of,
                      Visit&& visit) {
  for (int heading = 0; heading < count; ++heading) {
    if (heading == nearest || goal.reaches_heading(radians_of(heading))) visit(heading);
  }
}

inline SnappingError snapping_error_between(const Goal& asked, const Pose& taken) {
  const double turn = asked.heading ? normalized_angle(*asked.heading - taken.heading) : 0;
  return {distance(asked.point, taken.point()), std::abs(turn)};
}

}  // namespace wend
