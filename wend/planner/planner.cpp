#include "wend/planner/planner.hpp"

#include <limits>
#include <utility>

namespace wend {

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
  return do_plan(query, out);
}

std::optional<Status> Planner::begin(const Query& query, Plan& out) {
  if (const auto failed = check(query, out)) return failed;
  return do_begin(query, out);
}

Expected<void, Error> Planner::update(FreeSpace free_space, std::span<const Cell> changed) {
  free_space_ = std::move(free_space);
  if (auto failed = do_update(changed)) return Unexpected<Error>(*std::move(failed));
  return {};
}

std::string Planner::reason(const Query& query, Status status) const {
  const std::string reason = do_reason(query, status);
  return reason.empty() ? std::string(describe(status)) : reason;
}

std::optional<Status> Planner::check(const Query& query, Plan& out) {
  out.path.clear();
  out.cost = std::numeric_limits<double>::infinity();
  out.bound = Plan::kNoBound;
  out.moves.clear();
  out.start_snapping_error = {};
  out.goal_snapping_error = {};
  out.metrics = {};
  if (query.goals.empty()) return Status::unsupported_query;
  return do_check(query);
}

}  // namespace wend
