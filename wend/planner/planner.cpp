#include "wend/planner/planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "wend/map/place_text.hpp"
#include "wend/planner/goal_region.hpp"

namespace wend {
namespace {

bool has_tolerances(const Goal& goal) {
  return goal.tolerance >= 0 && goal.heading_tolerance >= 0;  // neither is NaN
}

}  // namespace

Expected<Plan, PlanFailure> Planner::plan(const Query& query) {
  Plan out;
  const Status status = plan(query, out);
  if (status != Status::found) {
    return Unexpected<PlanFailure>({{status, reason(query, status)}, out.metrics});
  }
  return out;
}

Status Planner::plan(const Query& query, Plan& out) {
  if (const auto failed = check(query, out)) return *failed;
  watch_solutions(query);
  const Status status = do_plan(query, out);
  if (status == Status::found) tell_solution(out);
  return status;
}

std::optional<Status> Planner::begin(const Query& query, Plan& out) {
  if (const auto failed = check(query, out)) return failed;
  watch_solutions(query);
  return do_begin(query, out);
}

std::optional<Status> Planner::step(Plan& out) {
  const std::optional<Status> status = do_step(out);
  if (status == Status::found) tell_solution(out);
  return status;
}

void Planner::watch_solutions(const Query& query) {
  on_solution_ = query.on_solution;
  told_cost_ = std::numeric_limits<double>::quiet_NaN();
}

void Planner::tell_solution(const Plan& plan) {
  if (!on_solution_ || (plan.cost == told_cost_ && plan.bound == told_bound_)) return;
  told_cost_ = plan.cost;
  told_bound_ = plan.bound;
  on_solution_(plan);
}

Expected<void, Error> Planner::update(FreeSpace free_space, const SpaceChange& change) {
  free_space_.emplace(std::move(free_space));
  if (auto failed = do_update(change)) return Unexpected<Error>(*std::move(failed));
  return {};
}

void Planner::release() {
  do_release();
  free_space_.reset();
}

std::string Planner::reason(const Query& query, Status status) const {
  if (status == Status::unsupported_query) {
    if (query.goals.empty()) return "the query has no goal";
    if (!std::ranges::all_of(query.goals, has_tolerances)) {
      return "the tolerances of a goal must be at least 0";
    }
    if (std::isnan(query.limits.seconds)) return "the limit of seconds is NaN";
  }
  std::string reason = do_reason(query, status);
  if (reason.empty()) reason = describe(status);
  if (query.goals.empty()) return reason;
  const double tolerance = query.goals.front().tolerance;
  return reason +
         beyond_tolerance(query, status, distance_text(tolerance, free_space().map().frame()));
}

std::optional<Pose> Planner::do_place_of(const Pose& pose) const {
  const auto cell = cell_under(free_space(), pose.point());
  if (!cell) return std::nullopt;
  return pose_at(*cell, pose.heading);
}

void Planner::clear(Plan& out) {
  out.path.clear();
  out.cost = std::numeric_limits<double>::infinity();
  out.bound = Plan::kNoBound;
  out.moves.clear();
  out.start_snapping_error = {};
  out.goal_snapping_error = {};
  out.metrics = {};
}

std::optional<Status> Planner::check(const Query& query, Plan& out) {
  clear(out);
  if (query.goals.empty() || !std::ranges::all_of(query.goals, has_tolerances) ||
      std::isnan(query.limits.seconds)) {
    return Status::unsupported_query;
  }
  return do_check(query);
}

}  // namespace wend
