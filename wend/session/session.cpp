#include "wend/session/session.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "wend/base/mutex.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/planner/incremental/incremental_options.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/nearest_ends.hpp"

namespace wend {
namespace {

Unexpected<RequestFailure> no_plan(PlanFailure failure, double seconds = 0) {
  return Unexpected<RequestFailure>(RequestFailure{std::move(failure), seconds});
}

Unexpected<RequestFailure> no_plan(Error error) {
  return no_plan(PlanFailure{std::move(error), {}});
}

bool steps_from_cell_to_cell(const PlannerSpec& spec) {
  const PlannerInfo* info = planners().find(spec.name);
  return info != nullptr && !info->capabilities.any_angle;
}

/// The planner that answers again after edits: the one asked for if it resumes, else `replanner` with the same
/// moves.
PlannerSpec resuming(const PlannerSpec& spec) {
  const PlannerInfo* info = planners().find(spec.name);
  if (info == nullptr || info->capabilities.resumes) return spec;
  PlannerSpec replanner{std::string(ReplannerOptions::kPlanner)};
  const std::vector<OptionInfo> moves = option_schema<GridMoves>();
  std::ranges::copy_if(
      spec.options, std::back_inserter(replanner.options), [&](const auto& option) {
        return std::ranges::any_of(moves, [&](const OptionInfo& info) {
          return info.name == option.first ||
                 std::ranges::find(info.aliases, option.first) != info.aliases.end();
        });
      });
  return replanner;
}

}  // namespace

struct Session::State {
  /// The last field of costs, and what it is for.
  struct KeptField {
    std::uint64_t version;
    std::vector<Cell> goals;
    GridMoves moves;
    std::shared_ptr<const CostToGo> costs;
  };

  explicit State(SessionOptions chosen)
      : options(std::move(chosen)), planners(options.idle_planners) {}

  double now() const { return options.clock ? options.clock() : steady_seconds(); }

  Expected<PlanAnswer, RequestFailure> answer(const View& view, Planner& planner,
                                              const PlannerSpec& spec, const PlanRequest& request);
  Expected<Field, PlanFailure> field_to(const View& view, std::vector<Cell> goals, GridMoves moves,
                                        const Limits& limits);
  Status look_up(const View& view, const Query& query, Cell start, GridMoves moves, Plan& plan);

  /// Called with the lock. Makes the free space if map or robot have changed.
  Expected<View, Error> make_view();

  const SessionOptions options;
  WarmPlanners planners;

  Mutex mutex;  // guards what follows
  std::optional<GridMap> map;
  std::string frame_id = "map";
  std::string why_no_map = "no map has come yet";
  FreeSpaceOptions robot;
  std::uint64_t version = 0;
  std::optional<Obstacles> obstacles;  // of the last space
  ObstacleOptions obstacle_options;
  std::optional<Expected<View, Error>> kept_view;

  void forget_field() {
    const MutexLock lock(field_mutex);
    kept_field.reset();
  }

  Mutex field_mutex;  // guards the field, whose making does not stop planners
  std::optional<KeptField> kept_field;
};

Expected<Session::View, Error> Session::State::make_view() {
  if (!map) return failure(Status::invalid_map, why_no_map);
  if (kept_view) return *kept_view;
  if (!obstacles || obstacle_options != robot.obstacles()) {
    obstacle_options = robot.obstacles();
    obstacles.emplace(*map, obstacle_options);
  }
  auto space = make_free_space(*obstacles, robot.robot());
  if (space) {
    kept_view.emplace(View{*std::move(space), frame_id, version});
  } else {
    kept_view.emplace(Unexpected<Error>(std::move(space.error())));
  }
  return *kept_view;
}

Session::Session(SessionOptions options) : state_(std::make_unique<State>(std::move(options))) {}

Session::Session(GridMap map, FreeSpaceOptions robot, SessionOptions options)
    : Session(std::move(options)) {
  set_robot(std::move(robot));
  set_map(std::move(map));
}

Session::~Session() = default;

void Session::set_map(GridMap map, std::string frame_id) {
  const MutexLock lock(state_->mutex);
  state_->map = std::move(map);
  state_->frame_id = std::move(frame_id);
  state_->obstacles.reset();
  state_->kept_view.reset();
  ++state_->version;
}

Expected<SpaceChange, Error> Session::edit(const MapEdit& edit) {
  const MutexLock lock(state_->mutex);
  State& state = *state_;
  if (const auto seen = state.make_view(); !seen) return Unexpected<Error>(seen.error());
  View& view = **state.kept_view;  // NOLINT(bugprone-unchecked-optional-access): just made
  if (auto fault = fault_of(edit, view.space.map())) return Unexpected<Error>(*std::move(fault));
  // Whatever shares the space would make the edit copy it.
  state.map.reset();
  state.obstacles.reset();
  state.forget_field();
  auto planners = state.planners.release(state.version);
  auto change = view.space.edit(edit);
  state.map = view.space.map();
  state.obstacles = view.space.obstacles();
  if (change) view.version = ++state.version;
  state.planners.keep(std::move(planners), view.space, change ? *change : SpaceChange{},
                      state.version);
  return change;
}

void Session::clear_map(std::string why) {
  const MutexLock lock(state_->mutex);
  state_->map.reset();
  state_->why_no_map = std::move(why);
  state_->obstacles.reset();
  state_->kept_view.reset();
  ++state_->version;
}

void Session::set_robot(FreeSpaceOptions robot) {
  const MutexLock lock(state_->mutex);
  if (robot == state_->robot) return;
  state_->robot = std::move(robot);
  state_->kept_view.reset();
  ++state_->version;
}

Expected<Session::View, Error> Session::view() const {
  const MutexLock lock(state_->mutex);
  return state_->make_view();
}

Expected<PlanAnswer, RequestFailure> Session::plan(const PlanRequest& request) {
  auto seen = view();
  if (!seen) return no_plan(std::move(seen.error()));
  return plan(*seen, request);
}

Expected<PlanAnswer, RequestFailure> Session::plan(const View& view, const PlanRequest& request) {
  const PlannerSpec spec =
      request.observer == nullptr ? request.planner : without_leaps(request.planner);
  auto planner = state_->planners.take(view.space, view.version, spec);
  if (!planner) return no_plan(std::move(planner.error()));
  return state_->answer(view, **planner, spec, request);
}

Expected<PlanAnswer, RequestFailure> Session::State::answer(const View& view, Planner& planner,
                                                            const PlannerSpec& spec,
                                                            const PlanRequest& request) {
  const Units units(view.space.map());
  const auto moves = planner.grid_moves();
  const Leeway leeway = request.leeway();
  if (auto fault = fault_of(leeway)) return no_plan(*std::move(fault));
  Explainer explainer(view.space, units, moves.value_or(GridMoves{}), options.hints);
  explainer.allow(leeway);
  Query query = query_of(request, view.space.map().frame());
  if (query.goals.empty())
    return no_plan(Error{Status::unsupported_query, "there is no goal", "goals"});
  if (request.from_field && !(moves && steps_from_cell_to_cell(spec))) {
    return no_plan(Error{Status::unsupported_query,
                         "only planners that step from cell to cell answer from a field",
                         "from_field"});
  }
  PlanAnswer answer{.space = view.space, .plan = {}, .moves = moves};
  EasedQuery eased(std::move(query), planner, explainer, units, leeway);
  const double begin = now();
  const auto search = [&] {
    const Query& asked = eased.query();
    return request.from_field
               ? look_up(view, asked, ends_of(asked, units).start.cell, *moves, answer.plan)
               : planner.plan(asked, answer.plan);
  };
  Status status = search();
  if (eased.ease_goals(status)) status = search();
  answer.search_seconds = now() - begin;
  if (status != Status::found) {
    const SearchMetrics& metrics = answer.plan.metrics;
    std::string why = request.explain
                          ? explainer.explain(planner, eased.query(), ends_of(eased.query(), units),
                                              status, metrics)
                          : planner.reason(eased.query(), status);
    return no_plan(PlanFailure{{status, std::move(why)}, metrics}, answer.search_seconds);
  }
  eased.finish(answer.plan);
  answer.notes = eased.notes();
  answer.lead_out = eased.lead_out();
  if (const auto remaining = eased.remaining()) {
    answer.remaining = *remaining * view.space.map().frame().resolution;
  }
  finish_path(answer, request, eased.lead());
  return answer;
}

/// Plan::metrics are those of making the field: 0 if it was kept.
Status Session::State::look_up(const View& view, const Query& query, Cell start, GridMoves moves,
                               Plan& plan) {
  const auto field = field_to(view, goal_cells(view.space, query), moves, query.limits);
  if (!field) {
    plan.metrics = field.error().metrics;
    return field.error().status;
  }
  auto found = field->costs->path_from(start);
  if (!found) {
    plan.metrics = field->metrics;
    return found.error().status;
  }
  plan = *std::move(found);
  plan.metrics = field->metrics;
  return Status::found;
}

Expected<PlanAnswer, RequestFailure> Session::replan(const PlanRequest& request) {
  auto seen = view();
  if (!seen) return no_plan(std::move(seen.error()));
  return replan(*seen, request);
}

Expected<PlanAnswer, RequestFailure> Session::replan(const View& view, const PlanRequest& request) {
  PlanRequest again = request;
  again.planner = resuming(request.planner);
  return plan(view, again);
}

Expected<std::vector<Expected<PlanAnswer, RequestFailure>>, Error> Session::plan_all(
    std::span<const PlanRequest> requests, const PlannerSpec& planner, Workers& workers) {
  const auto seen = view();
  if (!seen) return Unexpected<Error>(seen.error());
  auto planners = state_->planners.take(seen->space, seen->version, planner, workers.count());
  if (!planners) return Unexpected<Error>(std::move(planners.error()));
  using Answer = Expected<PlanAnswer, RequestFailure>;
  std::vector<Answer> answers(requests.size(), no_plan(Error{Status::cancelled, "not planned"}));
  workers.run(requests.size(), [&](std::size_t i, unsigned worker) {
    answers[i] = state_->answer(*seen, *(*planners)[worker], planner, requests[i]);
  });
  return answers;
}

Expected<WarmPlanner, Error> Session::planner(const PlannerSpec& spec) {
  const auto seen = view();
  if (!seen) return Unexpected<Error>(seen.error());
  return state_->planners.take(seen->space, seen->version, spec);
}

Expected<std::vector<WarmPlanner>, Error> Session::planners(const PlannerSpec& spec,
                                                            std::size_t count) {
  const auto seen = view();
  if (!seen) return Unexpected<Error>(seen.error());
  return state_->planners.take(seen->space, seen->version, spec, count);
}

Expected<MapPose, Error> Session::nearest(const MapPose& pose) const {
  const auto seen = view();
  if (!seen) return Unexpected<Error>(seen.error());
  const Frame& frame = seen->space.map().frame();
  const Pose asked = frame.to_grid(pose);
  if (seen->space.fits(asked)) return pose;
  const auto found = nearest_pose(seen->space, asked);
  if (!found) {
    return failure(Status::unsupported_query, "the robot fits nowhere on the map at this heading",
                   "pose");
  }
  return frame.to_metres(*found);
}

Expected<NoPath, Error> Session::why_no_path(MapPoint start, MapPoint goal, GridMoves moves) const {
  const auto seen = view();
  if (!seen) return Unexpected<Error>(seen.error());
  const FreeSpace& space = seen->space;
  const Frame& frame = space.map().frame();
  const auto from = cell_under(space, frame.to_grid(start));
  const auto to = cell_under(space, frame.to_grid(goal));
  if (!from) return failure(Status::start_outside, "the start is outside the map", "start");
  if (!to) return failure(Status::goal_outside, "the goal is outside the map", "goal");
  return explain_no_path(space, *from, *to, moves);
}

Expected<Session::Field, PlanFailure> Session::cost_to_go(const View& view, std::vector<Cell> goals,
                                                          GridMoves moves, const Limits& limits) {
  return state_->field_to(view, std::move(goals), moves, limits);
}

Expected<Session::Field, PlanFailure> Session::State::field_to(const View& view,
                                                               std::vector<Cell> goals,
                                                               GridMoves moves,
                                                               const Limits& limits) {
  // Making it under its lock lets a second caller wait for it, not make another.
  const MutexLock lock(field_mutex);
  if (kept_field && kept_field->version == view.version && kept_field->goals == goals &&
      kept_field->moves == moves) {
    return Field{kept_field->costs, {}};
  }
  auto made = CostToGo::make(view.space, goals, moves, limits);
  if (!made) return Unexpected<PlanFailure>(std::move(made.error()));
  const SearchMetrics metrics = made->metrics();
  auto costs = std::make_shared<const CostToGo>(*std::move(made));
  kept_field = KeptField{view.version, std::move(goals), moves, costs};
  return Field{std::move(costs), metrics};
}

Expected<void, Error> Session::build_index(std::string_view planner,
                                           const IndexBuilding& building) {
  const PlannerInfo* info = wend::planners().find(planner);
  if (info == nullptr) {
    return failure(Status::invalid_option, wend::planners().unknown("planner", planner));
  }
  if (!info->index_support) {
    return failure(Status::invalid_option, info->name + " does not use an index");
  }
  const auto seen = view();
  if (!seen) return Unexpected<Error>(seen.error());
  auto index = info->index_support->build(seen->space, building);
  if (!index) return Unexpected<Error>(std::move(index.error()));
  state_->planners.set_index(planner, *std::move(index));
  return {};
}

void Session::set_index(std::string_view planner, IndexBytes index) {
  state_->planners.set_index(planner, std::move(index));
}

}  // namespace wend
