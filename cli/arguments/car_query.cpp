#include "cli/arguments/car_query.hpp"

#include <fmt/format.h>

#include <utility>

#include "cli/exit_code.hpp"
#include "cli/output/explainer.hpp"
#include "cli/output/plan_text.hpp"
#include "wend/report/plan_report.hpp"

namespace wend::cli {

CarQuery::CarQuery(FreeSpace space, const Coordinates& coordinates, int unit,
                   const EndArguments& ends)
    : space_(std::move(space)),
      coordinates_(coordinates),
      unit_(unit),
      start_(parse_start_pose(coordinates_, ends.start)) {
  for (const std::string& goal : ends.goals) goals_.push_back(parse_goal_pose(coordinates_, goal));
}

void CarQuery::check(const ShownLayers& layers) const {
  if (!layers.any_from(LayerSource::cost_to_go)) return;
  throw InputError("--show: cost and policy are of robots that move from cell to cell");
}

Query CarQuery::query() const {
  Query query{{start_.point.x, start_.point.y, start_.heading.value_or(0)}, {}};
  for (const TypedPose& goal : goals_) query.goals.push_back(goal.goal());
  return query;
}

std::vector<std::string> CarQuery::move_to_nearest() {
  throw InputError("--nearest is for planners that move from cell to cell");
}

Scene CarQuery::scene() const {
  Scene scene{.space = space_};
  scene.start = start_.place();
  for (const TypedPose& goal : goals_) scene.goals.push_back(goal.place());
  scene.unit = unit_;
  return scene;
}

std::optional<CostToGo> CarQuery::cost_to_go(const Limits& /*limits*/) const {
  return std::nullopt;
}

SearchRecorder CarQuery::recorder() const { return SearchRecorder(space_, unit_); }

PosthocTrace CarQuery::trace(TraceForm form, std::uint64_t most_events) const {
  return {space_, query(), unit_, form, most_events};
}

std::string CarQuery::reason(const Planner& planner, Status status, const Limits& limits,
                             const SearchMetrics& metrics) const {
  if (is_limit(status)) return explain_limit(status, limits, metrics);
  if (status == Status::start_outside) return outside("start", start_);
  if (status == Status::goal_outside) return outside("goal", goals_.front());
  return as_typed() + planner.reason(query(), status);
}

std::string CarQuery::outside(const std::string& name, const TypedPose& pose) const {
  return fmt::format("the {} {} lies outside the map, which covers {}", name, pose.text,
                     coordinates_.extent_of_corners());
}

/// Reasons are told in corners of the lattice: where these are not what people typed, that comes
/// first.
std::string CarQuery::as_typed() const {
  if (!coordinates_.metric() && unit_ == 1) return {};
  std::vector<std::string> goals;
  goals.reserve(goals_.size());
  for (const TypedPose& goal : goals_) goals.push_back(goal.text);
  return fmt::format("from {} to {}: ", start_.text, fmt::join(goals, " or "));
}

std::string CarQuery::steps(const Plan& plan, const Screen& /*screen*/) const {
  return drive_commands(plan, space_.map().frame().y_up);
}

std::string CarQuery::summary(const PlanResult& result) const {
  return drive_summary(result, coordinates_, goals_.size());
}

}  // namespace wend::cli
