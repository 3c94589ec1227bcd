#include "cli/arguments/cell_query.hpp"

#include <utility>

#include <fmt/format.h>

#include "cli/arguments/nearest_ends.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/no_path_scene.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/plan_text.hpp"

namespace wend::cli {
namespace {

bool is_about_the_start(Status status) {
  return status == Status::start_outside || status == Status::start_blocked;
}

bool is_about_a_goal(Status status) {
  return status == Status::goal_outside || status == Status::goal_blocked ||
         status == Status::unreachable;
}

}  // namespace

CellQuery::CellQuery(FreeSpace space, const Coordinates& coordinates, GridMoves moves,
                     const EndArguments& ends)
    : space_(std::move(space)),
      coordinates_(coordinates),
      moves_(moves),
      start_(coordinates_.parse("start", ends.start)) {
  for (const std::string& goal : ends.goals) goals_.push_back(coordinates_.parse("goal", goal));
}

std::vector<Cell> CellQuery::goal_cells() const {
  std::vector<Cell> cells;
  cells.reserve(goals_.size());
  for (const Place& goal : goals_) cells.push_back(goal.cell);
  return cells;
}

Query CellQuery::query() const {
  Query query{pose_at(start_.cell), {}};
  for (const Cell goal : goal_cells()) query.goals.emplace_back(pose_at(goal));
  return query;
}

std::vector<std::string> CellQuery::move_to_nearest() {
  if (goals_.size() > 1) throw InputError("--nearest moves one goal: name one");
  Ends ends{start_, goals_.front()};
  auto notes = cli::move_to_nearest(ends, space_, coordinates_, moves_);
  start_ = ends.start;
  goals_ = {ends.goal};
  return notes;
}

Scene CellQuery::scene() const {
  Scene scene = scene_between(space_, start_.cell, goals_.front().cell);
  scene.goals.clear();
  for (const Cell goal : goal_cells()) scene.goals.emplace_back(centre_of(goal));
  return scene;
}

Scene CellQuery::scene_of_failure(Status status) const {
  if (!is_about_the_start(status) && !is_about_a_goal(status)) return scene();
  return no_path_scene(space_, start_.cell, goal_cells(), moves_, coordinates_);
}

std::optional<CostToGo> CellQuery::cost_to_go(const Limits& limits) const {
  auto made = CostToGo::make(space_, goal_cells(), moves_, limits);
  if (!made) return std::nullopt;
  return *std::move(made);
}

SearchRecorder CellQuery::recorder() const { return SearchRecorder(space_); }

PosthocTrace CellQuery::trace(TraceForm form, std::uint64_t most_events) const {
  return {space_, start_.cell, goal_cells(), form, most_events};
}

std::string CellQuery::reason(const Planner& /*planner*/, Status status, const Limits& limits,
                              const SearchMetrics& metrics) const {
  const Explainer explainer(space_, coordinates_, moves_);
  if (goals_.size() == 1 || !is_about_a_goal(status)) {
    return explainer.explain(status, {start_, goals_.front()}, limits, metrics);
  }
  std::vector<std::string> reasons;
  for (const Place& goal : goals_) {
    const std::string blocked = explainer.blocked(goal);
    reasons.push_back(blocked.empty() ? "no path leads to the goal " + goal.text : blocked);
  }
  return fmt::format("none of {} goals can be reached: {}", goals_.size(),
                     fmt::join(reasons, "; "));
}

std::string CellQuery::steps(const Plan& plan, const Screen& screen) const {
  return is_small(space_.map(), screen) ? path_line(plan.path) : "";
}

std::string CellQuery::summary(const PlanResult& result) const {
  std::string goal;
  if (goals_.size() > 1) {
    goal = goal_line(coordinates_.text(result.plan.path.cells().back()), goals_.size());
  }
  return goal + plan_summary(result, space_.map().frame());
}

}  // namespace wend::cli
