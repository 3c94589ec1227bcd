#include "cli/commands/typed_query.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "cli/arguments/planner_argument.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/explainer.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/plan_text.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/report/plan_report.hpp"
#include "wend/robot/nearest_passable.hpp"

namespace wend::cli {
namespace {

bool is_about_the_start(Status status) {
  return status == Status::start_outside || status == Status::start_blocked;
}

bool is_about_a_goal(Status status) {
  return status == Status::goal_outside || status == Status::goal_blocked ||
         status == Status::unreachable;
}

struct Pair {
  Cell first;
  Cell second;
};

double apart(Cell a, Cell b) { return distance(centre_of(a), centre_of(b)); }

/// `first` moved to the nearest cell of all, then `second` to the nearest one connected to that.
std::optional<Pair> nearest_pair(const FreeSpace& space, Cell first, Cell second,
                                 Adjacency adjacency) {
  const auto near_first = nearest_passable(space, first);
  if (!near_first) return std::nullopt;
  const auto near_second = nearest_passable(space, second, near_first, adjacency);
  if (!near_second) return std::nullopt;
  return Pair{*near_first, *near_second};
}

/// Moves both ends, in the order that gives the smaller sum of distances.
std::optional<Pair> nearest_ends(const FreeSpace& space, Cell start, Cell goal,
                                 Adjacency adjacency) {
  const auto from_start = nearest_pair(space, start, goal, adjacency);
  const auto from_goal = nearest_pair(space, goal, start, adjacency);
  if (!from_start || !from_goal) return std::nullopt;
  const double start_first = apart(start, from_start->first) + apart(goal, from_start->second);
  const double goal_first = apart(goal, from_goal->first) + apart(start, from_goal->second);
  if (start_first <= goal_first) return from_start;
  return Pair{from_goal->second, from_goal->first};
}

PoseAnchor anchor_of(int unit) { return unit > 0 ? PoseAnchor::corner : PoseAnchor::cell; }

/// Is it a cell of the map that the robot cannot stand on?
bool is_blocked(const FreeSpace& space, Cell cell) {
  return space.contains(cell) && !space.passable(cell);
}

}  // namespace

std::unique_ptr<TypedQuery> typed_query(const PlannerSpec& planner, const FreeSpace& space,
                                        const Coordinates& coordinates, const EndArguments& ends) {
  const StateKind kind = info_of(planner).state_kind;
  if (has_heading(kind)) {
    const bool corners = kind == StateKind::corner_pose;
    return std::make_unique<PoseQuery>(space, coordinates,
                                       corners ? unit_of(planner, coordinates.frame()) : 0, ends);
  }
  return std::make_unique<CellQuery>(space, coordinates, moves_of(planner), ends);
}

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
  if (goals_.size() > 1) throw InputError("--nearest supports exactly one goal");
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
    reasons.push_back(blocked.empty() ? "there is no path to the goal " + goal.text : blocked);
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
  return goal + robot_line(space_, coordinates_) + plan_summary(result, space_.map().frame());
}

PoseQuery::PoseQuery(FreeSpace space, const Coordinates& coordinates, int unit,
                     const EndArguments& ends)
    : space_(std::move(space)),
      coordinates_(coordinates),
      unit_(unit),
      start_(parse_start_pose(coordinates_, ends.start, anchor_of(unit))) {
  for (const std::string& goal : ends.goals) {
    goals_.push_back(parse_goal_pose(coordinates_, goal, anchor_of(unit)));
  }
}

void PoseQuery::check(const ShownLayers& layers) const {
  if (!layers.any_from(LayerSource::cost_to_go)) return;
  throw InputError("--show: cost and policy support grid planners only");
}

Query PoseQuery::query() const {
  Query query{{start_.point.x, start_.point.y, start_.heading.value_or(0)}, {}};
  for (const TypedPose& goal : goals_) query.goals.push_back(goal.goal());
  return query;
}

std::vector<std::string> PoseQuery::move_to_nearest() {
  throw InputError("--nearest supports grid planners only");
}

Scene PoseQuery::scene() const {
  Scene scene{.space = space_};
  scene.start = start_.place();
  for (const TypedPose& goal : goals_) scene.goals.push_back(goal.place());
  if (unit_ > 0) scene.unit = unit_;
  return scene;
}

std::optional<CostToGo> PoseQuery::cost_to_go(const Limits& /*limits*/) const {
  return std::nullopt;
}

SearchRecorder PoseQuery::recorder() const { return SearchRecorder(space_, unit_); }

PosthocTrace PoseQuery::trace(TraceForm form, std::uint64_t most_events) const {
  return {space_, query(), unit_, form, most_events};
}

std::string PoseQuery::reason(const Planner& planner, Status status, const Limits& limits,
                              const SearchMetrics& metrics) const {
  if (is_limit(status)) return explain_limit(status, limits, metrics);
  if (status == Status::start_outside) return outside("start", start_);
  if (status == Status::goal_outside) return outside("goal", goals_.front());
  return as_typed() + planner.reason(query(), status);
}

std::string PoseQuery::outside(const std::string& name, const TypedPose& pose) const {
  return fmt::format("the {} {} is outside the map, which covers {}", name, pose.text,
                     unit_ > 0 ? coordinates_.extent_of_corners() : coordinates_.extent());
}

/// Reasons are given in lattice vertices. If these are not what people typed, the typed text comes
/// first.
std::string PoseQuery::as_typed() const {
  if (!coordinates_.metric() && unit_ <= 1) return {};
  std::vector<std::string> goals;
  goals.reserve(goals_.size());
  for (const TypedPose& goal : goals_) goals.push_back(goal.text);
  return fmt::format("from {} to {}: ", start_.text, fmt::join(goals, " or "));
}

std::string PoseQuery::steps(const Plan& plan, const Screen& /*screen*/) const {
  constexpr std::size_t kMostCommands = 400;
  if (unit_ == 0 && plan.moves.size() > kMostCommands) return "";
  return drive_commands(plan, space_.map().frame());
}

std::string PoseQuery::summary(const PlanResult& result) const {
  return (unit_ > 0 ? robot_line(space_, coordinates_) : "") +
         drive_summary(result, coordinates_, goals_.size());
}

std::vector<std::string> move_to_nearest(Ends& ends, const FreeSpace& space,
                                         const Coordinates& coordinates, GridMoves moves) {
  std::vector<std::string> notes;
  const Explainer explainer(space, coordinates, moves);
  const Adjacency adjacency = moves.adjacency();
  const auto move = [&](Place& place, std::optional<Cell> cell, std::string_view preposition) {
    if (!cell || *cell == place.cell) return;
    notes.push_back(fmt::format("{}; planning {} {}, {} away", explainer.blocked(place),
                                preposition, coordinates.text(*cell),
                                coordinates.length(apart(place.cell, *cell))));
    place.cell = *cell;
    place.text = coordinates.text(*cell);
  };
  const bool start_blocked = is_blocked(space, ends.start.cell);
  const bool goal_blocked = is_blocked(space, ends.goal.cell);
  if (start_blocked && goal_blocked) {
    const auto pair = nearest_ends(space, ends.start.cell, ends.goal.cell, adjacency);
    if (!pair) return notes;
    move(ends.start, pair->first, "from");
    move(ends.goal, pair->second, "to");
  } else if (start_blocked && space.passable(ends.goal.cell)) {
    move(ends.start, nearest_passable(space, ends.start.cell, ends.goal.cell, adjacency), "from");
  } else if (goal_blocked && space.passable(ends.start.cell)) {
    move(ends.goal, nearest_passable(space, ends.goal.cell, ends.start.cell, adjacency), "to");
  }
  return notes;
}

}  // namespace wend::cli
