#include "wend/session/session.hpp"

#include <cmath>
#include <utility>

#include "wend/base/mutex.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/session/nearest_ends.hpp"

namespace wend {
namespace {

Point in_grid(const Frame& frame, MapPoint point) { return frame.to_grid(Point{point.x, point.y}); }

Pose in_grid(const Frame& frame, const MapPose& pose) {
  return frame.to_grid(Pose{pose.x, pose.y, pose.heading});
}

MapPose in_metres(const Frame& frame, const Pose& pose) {
  const auto metres = frame.to_metres(pose);
  return {metres.x, metres.y, metres.heading};
}

Unexpected<RequestFailure> no_plan(PlanFailure failure, double seconds = 0) {
  return Unexpected<RequestFailure>(RequestFailure{std::move(failure), seconds});
}

Unexpected<RequestFailure> no_plan(Error error) {
  return no_plan(PlanFailure{std::move(error), {}});
}

Ends ends_of(const Query& query, const Units& units) {
  Ends ends{units.place("start", query.start.point()), {}};
  for (const Goal& goal : query.goals) ends.goals.push_back(units.place("goal", goal.point));
  return ends;
}

/// Moves start and goal as --nearest does. Returns a sentence for each.
Expected<std::vector<std::string>, Error> move_ends(Query& query, const Planner& planner,
                                                    const Explainer& explainer,
                                                    const Units& units) {
  if (!planner.grid_moves() || query.goals.size() != 1) {
    return failure(Status::unsupported_query,
                   "the nearest free cell is for one goal, and planners on cells", "nearest");
  }
  Ends ends = ends_of(query, units);
  const Ends before = ends;
  auto notes = explainer.move_to_nearest(ends);
  if (ends.start.cell != before.start.cell) query.start = pose_at(ends.start.cell);
  if (ends.goals.front().cell != before.goals.front().cell) {
    query.goals.front().point = centre_of(ends.goals.front().cell);
  }
  return notes;
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
  std::optional<Expected<View, Error>> made;

  Mutex field_mutex;  // guards the field, whose making does not stop planners
  std::optional<KeptField> field;
};

Expected<Session::View, Error> Session::State::make_view() {
  if (!map) return failure(Status::invalid_map, why_no_map);
  if (made) return *made;
  if (!obstacles || obstacle_options != robot.obstacles()) {
    obstacle_options = robot.obstacles();
    obstacles.emplace(*map, obstacle_options);
  }
  auto space = make_free_space(*obstacles, robot.robot());
  if (space) {
    made.emplace(View{*std::move(space), frame_id, version});
  } else {
    made.emplace(Unexpected<Error>(std::move(space.error())));
  }
  return *made;
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
  state_->made.reset();
  ++state_->version;
}

void Session::clear_map(std::string why) {
  const MutexLock lock(state_->mutex);
  state_->map.reset();
  state_->why_no_map = std::move(why);
  state_->obstacles.reset();
  state_->made.reset();
  ++state_->version;
}

void Session::set_robot(FreeSpaceOptions robot) {
  const MutexLock lock(state_->mutex);
  if (robot == state_->robot) return;
  state_->robot = std::move(robot);
  state_->made.reset();
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
  auto planner = state_->planners.take(view.space, view.version, request.planner);
  if (!planner) return no_plan(std::move(planner.error()));
  const Units units(view.space.map());
  const auto moves = (*planner)->grid_moves();
  const Explainer explainer(view.space, units, moves.value_or(GridMoves{}), state_->options.hints);
  Query query = query_of(request, view.space.map().frame());
  PlanAnswer answer{.space = view.space, .plan = {}, .moves = moves};
  if (request.nearest) {
    auto notes = move_ends(query, **planner, explainer, units);
    if (!notes) return no_plan(std::move(notes.error()));
    answer.notes = *std::move(notes);
  }
  const double begin = state_->now();
  const Status status = (*planner)->plan(query, answer.plan);
  answer.search_seconds = state_->now() - begin;
  const SearchMetrics& metrics = answer.plan.metrics;
  if (status != Status::found) {
    std::string why =
        query.goals.empty()
            ? "there is no goal"
            : explainer.explain(**planner, query, ends_of(query, units), status, metrics);
    return no_plan(PlanFailure{{status, std::move(why)}, metrics}, answer.search_seconds);
  }
  finish_path(answer, request);
  return answer;
}

Expected<std::vector<Expected<PlanAnswer, RequestFailure>>, Error> Session::plan_all(
    std::span<const PlanRequest> requests, const PlannerSpec& planner, Workers& workers) {
  const auto seen = view();
  if (!seen) return Unexpected<Error>(seen.error());
  auto planners = state_->planners.take(seen->space, seen->version, planner, workers.count());
  if (!planners) return Unexpected<Error>(std::move(planners.error()));
  const Frame& frame = seen->space.map().frame();
  using Answer = Expected<PlanAnswer, RequestFailure>;
  std::vector<Answer> answers(requests.size(), no_plan(Error{Status::cancelled, "not planned"}));
  workers.run(requests.size(), [&](std::size_t i, unsigned worker) {
    Planner& its = *(*planners)[worker];
    auto plan = its.plan(query_of(requests[i], frame));
    if (!plan) {
      answers[i] = no_plan(std::move(plan.error()));
      return;
    }
    PlanAnswer answer{.space = seen->space, .plan = *std::move(plan), .moves = its.grid_moves()};
    finish_path(answer, requests[i]);
    answers[i] = std::move(answer);
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
  const Pose asked = in_grid(frame, pose);
  if (seen->space.fits(asked)) return pose;
  const auto found = nearest_pose(seen->space, asked);
  if (!found) {
    return failure(Status::unsupported_query, "the robot fits nowhere on the map at this heading",
                   "pose");
  }
  return in_metres(frame, *found);
}

Expected<NoPath, Error> Session::why_no_path(MapPoint start, MapPoint goal, GridMoves moves) const {
  const auto seen = view();
  if (!seen) return Unexpected<Error>(seen.error());
  const FreeSpace& space = seen->space;
  const Frame& frame = space.map().frame();
  const auto from = cell_under(space, in_grid(frame, start));
  const auto to = cell_under(space, in_grid(frame, goal));
  if (!from) return failure(Status::start_outside, "the start is outside the map", "start");
  if (!to) return failure(Status::goal_outside, "the goal is outside the map", "goal");
  return explain_no_path(space, *from, *to, moves);
}

Expected<Session::Field, RequestFailure> Session::cost_to_go(const View& view,
                                                             std::vector<Cell> goals,
                                                             GridMoves moves,
                                                             const Limits& limits) {
  // Making it under its lock lets a second caller wait for it, not make another.
  const MutexLock lock(state_->field_mutex);
  auto& kept = state_->field;
  if (kept && kept->version == view.version && kept->goals == goals && kept->moves == moves) {
    return Field{kept->costs, {}, 0};
  }
  const double begin = state_->now();
  auto made = CostToGo::make(view.space, goals, moves, limits);
  const double seconds = state_->now() - begin;
  if (!made) return no_plan(std::move(made.error()), seconds);
  const SearchMetrics metrics = made->metrics();
  auto costs = std::make_shared<const CostToGo>(*std::move(made));
  kept = State::KeptField{view.version, std::move(goals), moves, costs};
  return Field{std::move(costs), metrics, seconds};
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
