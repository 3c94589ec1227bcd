#include "wend/planner/planner.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "wend/planner/failure_causes.hpp"

namespace wend {

Expected<Plan, PlanFailure> Planner::plan(const Query& query) {
  Plan out;
  const Status status = plan(query, out);
  if (status != Status::found) {
    Failure why = failure(query, status);
    const OwnText* const own =
        why.causes.empty() ? nullptr : std::get_if<OwnText>(&why.causes.front());
    std::string message = own != nullptr ? own->text : std::string(describe(status));
    return Unexpected<PlanFailure>({{status, std::move(message)}, out.metrics, std::move(why)});
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

Failure Planner::failure(const Query& query, Status status) const {
  const auto end_of = [this](Point asked, std::optional<double> heading) {
    QueryEnd end{asked, asked, heading};
    const auto place = do_place_of({asked.x, asked.y, heading.value_or(0)});
    if (!place) return end;
    end.place = place->point();
    if (heading) end.heading = place->heading;
    return end;
  };
  Failure failure{.status = status,
                  .headings = !do_grid_moves(),
                  .places = do_place_grid(),
                  .start = end_of(query.start.point(), query.start.heading)};
  if (!query.goals.empty()) failure.tolerance = query.goals.front().tolerance;
  for (const Goal& goal : query.goals) failure.goals.push_back(end_of(goal.point, goal.heading));
  const auto fault = status == Status::unsupported_query ? fault_of(query) : std::nullopt;
  if (fault) {
    failure.causes = {*fault};
  } else {
    failure.causes = do_failure(query, status);
  }
  if (failure.causes.empty() && is_limit(status)) {
    failure.causes = {Stopped{query.limits.expansions, query.limits.seconds}};
  }
  return failure;
}

std::vector<FailureCause> Planner::do_failure(const Query& query, Status status) const {
  return do_grid_moves() ? causes_in_cells(free_space(), query, status)
                         : std::vector<FailureCause>();
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
  if (fault_of(query)) return Status::unsupported_query;
  return do_check(query);
}

}  // namespace wend
