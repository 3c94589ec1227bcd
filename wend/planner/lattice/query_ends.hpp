#pragma once

// The ends of a query of a planner with headings: which goals it can take, why it takes none, and how far its places are
// from what was asked for.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "wend/base/status.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/planner/failure.hpp"
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

/// The end whose heading is not finite or larger than `most`.
inline InvalidQuery wrong_heading(const Query& query, double most, InvalidQuery::Fault fault) {
  const auto is_wrong = [most](double heading) { return !(std::abs(heading) <= most); };
  if (is_wrong(query.start.heading)) return {fault, {}};
  const auto wrong = std::ranges::find_if(
      query.goals, [&](const Goal& goal) { return is_wrong(goal.heading.value_or(0)); });
  return {fault, static_cast<std::size_t>(wrong - query.goals.begin())};
}

/// What cause(index) says of each goal; if that is nothing, no path leads there.
template <class Cause>
std::vector<FailureCause> causes_of_goals(const Query& query, Cause&& cause) {
  std::vector<FailureCause> causes;
  for (std::size_t i = 0; i < query.goals.size(); ++i) {
    std::optional<FailureCause> why = cause(i);
    causes.push_back(why ? *std::move(why) : Separated{i});
  }
  return causes;
}

/// A polygon may fit at another heading than the one that the cause is about; where a goal leaves it open, all were tried.
inline FailureCause at_headings(FailureCause cause, const Goal& goal, const FreeSpace& space) {
  if (auto* const blocked = std::get_if<EndBlocked>(&cause)) {
    blocked->at_every_heading = !goal.heading && space.outline() != nullptr;
  }
  return cause;
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
