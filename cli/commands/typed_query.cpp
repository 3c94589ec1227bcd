#include "cli/commands/typed_query.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/no_path_scene.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/plan_text.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/report/plan_report.hpp"

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

std::unique_ptr<TypedQuery> typed_query(const PlannerSpec& planner, const FreeSpace& space,
                                        const Coordinates& coordinates, const EndArguments& ends) {
  if (info_of(planner).capabilities.headings) {
    const PlaceGrid places = places_of(info_of(planner), space, planner.options);
    return std::make_unique<PoseQuery>(space, coordinates, places, ends);
  }
  return std::make_unique<CellQuery>(space, coordinates, ends);
}

void add_goal_tolerance(Parser& app, std::string& tolerance) {
  app.add_option("--goal-tolerance", tolerance,
                 wrapped("How far from a goal the path may end: a distance in the units of --goal, "
                         "and for planners with headings an angle in degrees. The goal itself may "
                         "then be blocked"))
      .type_name("DISTANCE[,DEGREES]");
}

CellQuery::CellQuery(FreeSpace space, const Coordinates& coordinates, const EndArguments& ends)
    : space_(std::move(space)),
      coordinates_(coordinates),
      start_(coordinates_.parse("start", ends.start)),
      start_point_(coordinates_.parse_in_grid("start", ends.start)),
      tolerance_(parse_goal_tolerance(coordinates_, ends.tolerance)) {
  for (const std::string& goal : ends.goals) {
    goals_.push_back(coordinates_.parse("goal", goal));
    points_.push_back(coordinates_.parse_in_grid("goal", goal));
  }
  if (tolerance_.heading == 0) return;
  throw InputError(
      fmt::format("--goal-tolerance {}: grid planners have no headings: leave out the degrees",
                  ends.tolerance));
}

std::vector<Cell> CellQuery::goal_cells() const {
  std::vector<Cell> cells;
  cells.reserve(goals_.size());
  for (const Place& goal : goals_) cells.push_back(goal.cell);
  return cells;
}

Query CellQuery::query() const {
  Query query{{start_point_.x, start_point_.y}, {}};
  for (const Point point : points_) {
    query.goals.emplace_back(Pose{point.x, point.y}, tolerance_.distance);
  }
  return query;
}

Ends CellQuery::ends() const { return {start_, goals_}; }

void CellQuery::move_ends(const EasedQuery& eased) {
  const Query asked = query();
  const auto place = [this](const std::string& name, Point point) {
    return coordinates_.place(name, cell_at(point));
  };
  if (eased.lead().empty() && eased.query().start.point() != start_point_) {
    start_point_ = eased.query().start.point();
    start_ = place("start", start_point_);
  }
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    const Point moved = eased.query().goals[i].point;
    if (moved == asked.goals[i].point) continue;
    goals_[i] = place("goal", moved);
    points_[i] = moved;
  }
}

Scene CellQuery::scene() const {
  Scene scene = scene_between(space_, start_.cell, goals_.front().cell);
  scene.goals.clear();
  for (const Cell goal : goal_cells()) scene.goals.emplace_back(centre_of(goal));
  return scene;
}

Scene CellQuery::scene_of_failure(Status status, GridMoves moves) const {
  if (!is_about_the_start(status) && !is_about_a_goal(status)) return scene();
  return no_path_scene(space_, start_.cell, goal_cells(), moves, coordinates_);
}

std::optional<CostToGo> CellQuery::cost_to_go(GridMoves moves, const Limits& limits) const {
  auto made = CostToGo::make(space_, wend::goal_cells(space_, query()), moves, limits);
  if (!made) return std::nullopt;
  return *std::move(made);
}

SearchRecorder CellQuery::recorder() const { return SearchRecorder(space_); }

PosthocTrace CellQuery::trace(TraceForm form, std::uint64_t most_events) const {
  const bool near = tolerance_.distance > 0;
  return {space_, start_.cell, near ? wend::goal_cells(space_, query()) : goal_cells(), form,
          most_events};
}

std::string CellQuery::steps(const Plan& plan, const Screen& screen) const {
  return is_small(space_.map(), screen) ? path_line(plan.path, space_.map().frame()) : "";
}

std::string CellQuery::summary(const PlanResult& result) const {
  std::string goal;
  if (goals_.size() > 1) {
    goal = goal_line(coordinates_.text(cell_at(result.plan.path.points().back())), goals_.size());
  }
  return goal + shift_line(result, coordinates_) + robot_line(result) +
         plan_summary(result, space_.map().frame());
}

PoseQuery::PoseQuery(FreeSpace space, const Coordinates& coordinates, const PlaceGrid& places,
                     const EndArguments& ends)
    : space_(std::move(space)),
      coordinates_(coordinates),
      places_(places),
      start_(parse_start_pose(coordinates_, ends.start, places)),
      tolerance_(parse_goal_tolerance(coordinates_, ends.tolerance)) {
  for (const std::string& goal : ends.goals) {
    goals_.push_back(parse_goal_pose(coordinates_, goal, places));
  }
}

void PoseQuery::check(const ShownLayers& layers) const {
  if (!layers.any_from(LayerSource::cost_to_go)) return;
  throw InputError("--show: cost and policy support grid planners only");
}

Query PoseQuery::query() const {
  Query query{{start_.point.x, start_.point.y, start_.heading.value_or(0)}, {}};
  for (const TypedPose& typed : goals_) {
    Goal goal = typed.goal();
    goal.tolerance = tolerance_.distance;
    goal.heading_tolerance = tolerance_.heading;
    query.goals.push_back(goal);
  }
  return query;
}

Ends PoseQuery::ends() const {
  Ends ends{start_.named("start"), {}};
  for (const TypedPose& goal : goals_) ends.goals.push_back(goal.named("goal"));
  return ends;
}

void PoseQuery::move_ends(const EasedQuery& eased) {
  const Query& moved = eased.query();
  const auto take = [&](TypedPose& end, Point point) {
    if (point == end.point) return;
    end.point = point;
    end.text = coordinates_.text(point);
  };
  if (eased.lead().empty()) take(start_, moved.start.point());
  for (std::size_t i = 0; i < goals_.size(); ++i) take(goals_[i], moved.goals[i].point);
}

Scene PoseQuery::scene() const {
  Scene scene{.space = space_};
  scene.start = start_.place();
  for (const TypedPose& goal : goals_) scene.goals.push_back(goal.place());
  scene.places = places_;
  return scene;
}

std::optional<CostToGo> PoseQuery::cost_to_go(GridMoves /*moves*/, const Limits& /*limits*/) const {
  return std::nullopt;
}

SearchRecorder PoseQuery::recorder() const { return {space_, places_}; }

PosthocTrace PoseQuery::trace(TraceForm form, std::uint64_t most_events) const {
  return {space_, query(), places_, form, most_events};
}

std::string PoseQuery::steps(const Plan& plan, const Screen& /*screen*/) const {
  constexpr std::size_t kMostCommands = 400;
  if (!places_.on_corners() && plan.moves.size() > kMostCommands) return "";
  return drive_commands(plan, coordinates_.frame_of_texts());
}

std::string PoseQuery::summary(const PlanResult& result) const {
  return robot_line(result) + drive_summary(result, coordinates_, goals_.size());
}

}  // namespace wend::cli
