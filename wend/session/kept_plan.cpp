#include "wend/session/kept_plan.hpp"

#include <algorithm>
#include <utility>

#include "wend/path/polyline.hpp"
#include "wend/planner/rest_of_path.hpp"

namespace wend {
namespace {

bool is_near(const Path& path, Point point, const Frame& frame) {
  const Polyline line = polyline_of(path);
  return line.nearest(point, 0, line.length()).distance <= farthest_from_path(frame);
}

/// Has a search that ended like this not shown that the query cannot be answered?
bool is_open(Status status) {
  return status == Status::unreachable || status == Status::step_limit ||
         status == Status::expansion_limit || status == Status::time_limit;
}

}  // namespace

std::optional<KeptPlan::Rest> KeptPlan::rest(const Errand& errand, const Planner& planner,
                                             const Query& query) const {
  std::optional<AnsweredPath> kept;
  {
    const MutexLock lock(mutex_);
    kept = path_;
  }
  if (!kept || !(kept->errand == errand)) return std::nullopt;
  if (!is_near(*kept->answered, query.start.point(), errand.frame)) return std::nullopt;
  auto plan = planner.rest_of(*kept->found, query, kept->passed);
  if (!plan) return std::nullopt;
  plan->goal_snapping_error = kept->goal_snapping_error;
  return Rest{*std::move(plan), *std::move(kept)};
}

void KeptPlan::keep(AnsweredPath path) {
  const MutexLock lock(mutex_);
  path_ = std::move(path);
}

bool is_kept(Plan& rest, Status status, const Plan& found, double keep) {
  constexpr double kRounding = 1e-9;
  if (status != Status::found) return is_open(status);
  if (is_worth_changing_to(found.cost, rest.cost, keep)) return false;
  const bool dearer = rest.cost > found.cost * (1 + kRounding);
  rest.bound = !dearer          ? found.bound
               : found.cost > 0 ? found.bound * rest.cost / found.cost
                                : Plan::kNoBound;
  return true;
}

}  // namespace wend
