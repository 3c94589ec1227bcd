#include "wend/session/session.hpp"

#include <algorithm>
#include <utility>

#include "wend/base/mutex.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/kept_field.hpp"
#include "wend/session/kept_plan.hpp"
#include "wend/session/nearest_ends.hpp"
#include "wend/session/resuming.hpp"

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

Query unwatched(Query query) {
  query.observer = nullptr;
  query.on_solution = {};
  return query;
}

std::optional<Error> fault_of(const PlanRequest& request, bool steps) {
  if (!(request.keep >= 0)) {
    return Error{Status::invalid_option, "keep must be at least 0", "keep"};
  }
  if (request.goals.empty()) {
    return Error{Status::unsupported_query, "there is no goal", "goals"};
  }
  if (request.from_field && !steps) {
    return Error{Status::unsupported_query,
                 "only planners that step from cell to cell answer from a field", "from_field"};
  }
  return std::nullopt;
}

// What is nearly ready when the time ends is finished, so that the next call has it.
constexpr double kSecondsToFinish = 0.01;

bool is_stopped(Status status) {
  return status == Status::time_limit || status == Status::cancelled;
}

/// The copy constructor of tl::expected is noexcept: it would end the program where there is no memory.
Expected<Session::View, Error> copy_of(const Expected<Session::View, Error>& view) {
  if (!view) return Unexpected<Error>(view.error());
  return Session::View(*view);
}

/// Runs a query on a planner that is discarded if an exception, as of memory that ends, stops the query.
template <class Work>
auto discarding_if_stopped(std::span<WarmPlanner> planners, Work&& work) {
  struct Watch {
    std::span<WarmPlanner> watched;
    bool done = false;

    explicit Watch(std::span<WarmPlanner> those) : watched(those) {}
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    ~Watch() {
      if (done) return;
      for (WarmPlanner& planner : watched) planner.discard();
    }
  };
  Watch watch(planners);
  auto answer = work();
  watch.done = true;
  return answer;
}

}  // namespace

struct Session::State {
  /// What a view is made of.
  struct Parts {
    GridMap map;
    FreeSpaceOptions robot;
    std::string frame_id;
    std::uint64_t version;
    std::optional<Obstacles> obstacles;  // of this map, if they are known

    Expected<View, Error> made(const Deadline& deadline);
  };

  explicit State(SessionOptions chosen)
      : options(std::move(chosen)), planners(options.idle_planners) {}

  double now() const { return options.clock ? options.clock() : steady_seconds(); }

  /// `asked` is the planner that a robot asked for that replans; null: it does not.
  Expected<PlanAnswer, RequestFailure> answer(const View& view, Planner& planner,
                                              const PlannerSpec& spec, const PlanRequest& request,
                                              const Deadline& deadline,
                                              const PlannerSpec* asked = nullptr);
  Expected<PlanAnswer, RequestFailure> plan(const View& view, const PlanRequest& request,
                                            const Deadline& deadline);
  Expected<PlanAnswer, RequestFailure> replan(const View& view, const PlanRequest& request,
                                              const Deadline& deadline);
  std::optional<AnsweredPath> take_rest(const Errand& errand, const Planner& planner,
                                        const Query& query, double keep, Status& status,
                                        PlanAnswer& answer) const;
  void remember(Errand errand, std::optional<AnsweredPath> rest_of, const Path& found,
                const PlanAnswer& answer);
  Status look_up(const View& view, const Query& query, Cell start, GridMoves moves, Plan& plan);

  /// Makes the free space if map or robot have changed. Who needs the same one waits; nobody else does.
  Expected<View, Error> view(const Deadline& deadline = {});

  // Called with the lock.
  std::optional<Expected<View, Error>> known_view() const;
  Expected<SpaceChange, Error> edit_view(View& view, const MapEdit& edit);
  void forget_view();

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
  std::shared_ptr<Mutex> making;  // held by who makes the view of this version; null: nobody does

  KeptField field;  // of costs; has a lock of its own
  KeptPlan kept;    // the same
};

Expected<Session::View, Error> Session::State::Parts::made(const Deadline& deadline) {
  if (!obstacles) obstacles.emplace(map, robot.obstacles());
  auto space = make_free_space(*obstacles, robot.robot(), deadline.later(kSecondsToFinish));
  if (!space) return Unexpected<Error>(std::move(space.error()));
  return View{*std::move(space), frame_id, version};
}

std::optional<Expected<Session::View, Error>> Session::State::known_view() const {
  if (!map) return failure(Status::invalid_map, why_no_map);
  if (!kept_view) return std::nullopt;
  return copy_of(*kept_view);
}

Expected<Session::View, Error> Session::State::view(const Deadline& deadline) {
  std::shared_ptr<Mutex> turn;
  {
    const MutexLock lock(mutex);
    if (auto known = known_view()) return *std::move(known);
    if (!making) making = std::make_shared<Mutex>();
    turn = making;
  }
  const MutexLock my_turn(*turn);
  std::optional<Parts> parts;
  {
    const MutexLock lock(mutex);
    if (auto known = known_view()) return *std::move(known);
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): without a map, known_view() answers
    parts.emplace(*map, robot, frame_id, version, std::nullopt);
    if (obstacle_options == robot.obstacles()) parts->obstacles = obstacles;
  }
  auto made = parts->made(deadline);
  const MutexLock lock(mutex);
  if (version == parts->version) {
    if (made || !is_stopped(made.error().status)) kept_view = copy_of(made);
    obstacles = parts->obstacles;
    obstacle_options = parts->robot.obstacles();
  }
  return made;
}

void Session::State::forget_view() {
  kept_view.reset();
  making.reset();
  ++version;
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
  state_->forget_view();
}

Expected<SpaceChange, Error> Session::edit(const MapEdit& edit) {
  State& state = *state_;
  for (;;) {
    if (const auto seen = state.view(); !seen) return Unexpected<Error>(seen.error());
    const MutexLock lock(state.mutex);
    // Map and robot may have been replaced meanwhile.
    if (state.kept_view && *state.kept_view) return state.edit_view(**state.kept_view, edit);
  }
}

Expected<SpaceChange, Error> Session::State::edit_view(View& view, const MapEdit& edit) {
  if (auto fault = fault_of(edit, view.space.map())) return Unexpected<Error>(*std::move(fault));
  // Whatever shares the space would make the edit copy it.
  map.reset();
  obstacles.reset();
  field.forget();
  auto idle = planners.release(version);
  auto change = view.space.edit(edit);
  map = view.space.map();
  obstacles = view.space.obstacles();
  if (change) view.version = ++version;
  planners.keep(std::move(idle), view.space, change ? *change : SpaceChange{}, version);
  return change;
}

void Session::clear_map(std::string why) {
  const MutexLock lock(state_->mutex);
  state_->map.reset();
  state_->why_no_map = std::move(why);
  state_->obstacles.reset();
  state_->forget_view();
}

void Session::set_robot(FreeSpaceOptions robot) {
  const MutexLock lock(state_->mutex);
  if (robot == state_->robot) return;
  state_->robot = std::move(robot);
  state_->forget_view();
}

Expected<Session::View, Error> Session::view(const Deadline& deadline) const {
  return state_->view(deadline);
}

Expected<PlanAnswer, RequestFailure> Session::plan(const PlanRequest& request) {
  const Deadline deadline(request.limits);
  auto seen = view(deadline);
  if (!seen) return no_plan(std::move(seen.error()));
  return state_->plan(*seen, request, deadline);
}

Expected<PlanAnswer, RequestFailure> Session::plan(const View& view, const PlanRequest& request) {
  return state_->plan(view, request, Deadline(request.limits));
}

Expected<PlanAnswer, RequestFailure> Session::State::plan(const View& view,
                                                          const PlanRequest& request,
                                                          const Deadline& deadline) {
  const PlannerSpec spec =
      request.observer == nullptr ? request.planner : without_leaps(request.planner);
  auto planner = planners.take(view.space, view.version, spec, deadline);
  if (!planner) return no_plan(std::move(planner.error()));
  return discarding_if_stopped({&*planner, 1},
                               [&] { return answer(view, **planner, spec, request, deadline); });
}

/// An index is not built to explain: planners with one move as astar does.
std::string Session::explain(const View& view, const PlanRequest& request,
                             const PlanFailure& failure, const Deadline& deadline) {
  const PlannerInfo* const info = wend::planners().find(request.planner.name);
  if (info == nullptr || failure.status == Status::index_mismatch) return failure.message;
  const PlannerSpec spec = info->index_support ? PlannerSpec{"astar"} : request.planner;
  const Leeway leeway = request.leeway();
  auto planner = state_->planners.take(view.space, view.version, spec, deadline);
  if (!planner || request.goals.empty() || fault_of(leeway)) return failure.message;
  return discarding_if_stopped({&*planner, 1}, [&] {
    const Units units(view.space.map());
    Explainer explainer(view.space, units, (*planner)->grid_moves().value_or(GridMoves{}),
                        state_->options.hints);
    explainer.allow(leeway);
    explainer.stop_at(deadline);
    EasedQuery eased(query_of(request, view.space.map().frame()), **planner, explainer, units,
                     leeway);
    eased.ease_goals(failure.status);
    return explainer.explain(**planner, eased.query(), ends_of(eased.query(), units),
                             failure.status, failure.metrics);
  });
}

Expected<PlanAnswer, RequestFailure> Session::State::answer(const View& view, Planner& planner,
                                                            const PlannerSpec& spec,
                                                            const PlanRequest& request,
                                                            const Deadline& deadline,
                                                            const PlannerSpec* asked) {
  const Units units(view.space.map());
  const auto moves = planner.grid_moves();
  if (auto fault = fault_of(request, moves && steps_from_cell_to_cell(spec))) {
    return no_plan(*std::move(fault));
  }
  const Leeway leeway = request.leeway();
  if (auto fault = fault_of(leeway)) return no_plan(*std::move(fault));
  if (deadline.bounded() && moves &&
      !view.space.make_components(moves->adjacency(), deadline.later(kSecondsToFinish))) {
    return no_plan(Error{deadline.status(),
                         deadline.text() + ", before it was known which cells are connected"});
  }
  Explainer explainer(view.space, units, moves.value_or(GridMoves{}), options.hints);
  explainer.allow(leeway);
  explainer.stop_at(deadline);
  Query query = query_of(request, view.space.map().frame());
  PlanAnswer answer{.space = view.space, .plan = {}, .moves = moves};
  EasedQuery eased(std::move(query), planner, explainer, units, leeway);
  const double begin = now();
  const auto search = [&](bool watched) {
    eased.query().limits = deadline.left();
    const Query& query_now = eased.query();
    if (request.from_field) {
      return look_up(view, query_now, ends_of(query_now, units).start.cell, *moves, answer.plan);
    }
    return planner.plan(watched ? query_now : unwatched(query_now), answer.plan);
  };
  // An observer sees the search that answers, not one whose goals are replaced after it.
  const bool twice = request.observer != nullptr && eased.may_ease_goals();
  Status status = search(!twice);
  if (eased.ease_goals(status) || (twice && !is_limit(status))) status = search(true);
  answer.search_seconds = now() - begin;
  eased.query().limits = request.limits;  // as messages name them
  Errand errand;
  std::optional<AnsweredPath> rest_of;
  if (asked != nullptr) {
    errand = {*asked, eased.query().goals, view.space.map().frame()};
    rest_of = take_rest(errand, planner, eased.query(), request.keep, status, answer);
  }
  if (status != Status::found) {
    const SearchMetrics& metrics = answer.plan.metrics;
    std::string why = request.explain
                          ? explainer.explain(planner, eased.query(), ends_of(eased.query(), units),
                                              status, metrics)
                          : explainer.words(planner.failure(eased.query(), status), metrics);
    return no_plan(PlanFailure{{status, std::move(why)}, metrics}, answer.search_seconds);
  }
  const Path over_centres = asked != nullptr ? answer.plan.path : Path();
  eased.finish(answer.plan);
  answer.notes = eased.notes();
  answer.lead_out = eased.lead_out();
  if (const auto remaining = eased.remaining()) {
    answer.remaining = *remaining * view.space.map().frame().resolution;
  }
  auto disc = explainer.planned_as_disc(planner);
  if (!disc.empty()) answer.notes.push_back("the robot is " + std::move(disc));
  // Who receives paths sets the flag when one is good enough: that one is finished.
  finish_path(answer, request, eased.lead(),
              request.on_solution ? deadline.without_cancel() : deadline);
  if (asked != nullptr) remember(std::move(errand), std::move(rest_of), over_centres, answer);
  return answer;
}

/// Makes what is left of the last path the answer, if it is kept. Returns which path that is.
std::optional<AnsweredPath> Session::State::take_rest(const Errand& errand, const Planner& planner,
                                                      const Query& query, double keep,
                                                      Status& status, PlanAnswer& answer) const {
  auto rest = kept.rest(errand, planner, query);
  if (!rest) return std::nullopt;
  const bool same = status == Status::found && answer.plan.path == rest->plan.path;
  if (!same) {
    if (!is_kept(rest->plan, status, answer.plan, keep)) return std::nullopt;
    rest->plan.metrics = answer.plan.metrics;
    answer.plan = std::move(rest->plan);
    status = Status::found;
    if (query.on_solution) query.on_solution(answer.plan);
  }
  answer.kept = true;
  return std::move(rest->of);
}

/// Keeps the answer for the next time, and the path as the planner found it.
void Session::State::remember(Errand errand, std::optional<AnsweredPath> rest_of, const Path& found,
                              const PlanAnswer& answer) {
  AnsweredPath path;
  if (rest_of) {
    path = *std::move(rest_of);
  } else {
    path = {std::move(errand), std::make_shared<const Path>(found), nullptr,
            answer.plan.goal_snapping_error};
  }
  path.answered = std::make_shared<const Path>(answer.path());
  kept.keep(std::move(path));
}

/// Plan::metrics are those of making the field: 0 if it was kept.
Status Session::State::look_up(const View& view, const Query& query, Cell start, GridMoves moves,
                               Plan& plan) {
  const auto to_goals =
      field.get(view.space, view.version, goal_cells(view.space, query), moves, query.limits);
  if (!to_goals) {
    plan.metrics = to_goals.error().metrics;
    return to_goals.error().status;
  }
  auto found = to_goals->costs->path_from(start);
  if (!found) {
    plan.metrics = to_goals->metrics;
    return found.error().status;
  }
  plan = *std::move(found);
  plan.metrics = to_goals->metrics;
  return Status::found;
}

Expected<PlanAnswer, RequestFailure> Session::replan(const PlanRequest& request) {
  const Deadline deadline(request.limits);
  auto seen = view(deadline);
  if (!seen) return no_plan(std::move(seen.error()));
  return state_->replan(*seen, request, deadline);
}

Expected<PlanAnswer, RequestFailure> Session::replan(const View& view, const PlanRequest& request) {
  return state_->replan(view, request, Deadline(request.limits));
}

Expected<PlanAnswer, RequestFailure> Session::State::replan(const View& view,
                                                            const PlanRequest& request,
                                                            const Deadline& deadline) {
  PlannerSpec spec = resuming(request.planner, view.space);
  if (request.observer != nullptr) spec = without_leaps(std::move(spec));
  auto planner = planners.take(view.space, view.version, spec, deadline);
  if (!planner) return no_plan(std::move(planner.error()));
  return discarding_if_stopped({&*planner, 1}, [&] {
    return answer(view, **planner, spec, request, deadline, &request.planner);
  });
}

Expected<std::vector<Expected<PlanAnswer, RequestFailure>>, Error> Session::plan_all(
    std::span<const PlanRequest> requests, const PlannerSpec& planner, Workers& workers) {
  // Space and planner are made for all of them: the longest of their limits counts.
  Deadline preparing;
  if (!requests.empty()) {
    const auto longest = std::ranges::max_element(
        requests, {}, [](const PlanRequest& request) { return request.limits.seconds; });
    preparing = Deadline(longest->limits);
  }
  const auto seen = view(preparing);
  if (!seen) return Unexpected<Error>(seen.error());
  auto planners =
      state_->planners.take(seen->space, seen->version, planner, workers.count(), preparing);
  if (!planners) return Unexpected<Error>(std::move(planners.error()));
  using Answer = Expected<PlanAnswer, RequestFailure>;
  std::vector<Answer> answers(requests.size(), no_plan(Error{Status::cancelled, "not planned"}));
  return discarding_if_stopped(*planners, [&] {
    workers.run(requests.size(), [&](std::size_t i, unsigned worker) {
      answers[i] = state_->answer(*seen, *(*planners)[worker], planner, requests[i],
                                  Deadline(requests[i].limits));
    });
    return std::move(answers);
  });
}

Expected<WarmPlanner, Error> Session::planner(const PlannerSpec& spec, const Deadline& deadline) {
  const auto seen = view(deadline);
  if (!seen) return Unexpected<Error>(seen.error());
  return state_->planners.take(seen->space, seen->version, spec, deadline);
}

Expected<std::vector<WarmPlanner>, Error> Session::planners(const PlannerSpec& spec,
                                                            std::size_t count,
                                                            const Deadline& deadline) {
  const auto seen = view(deadline);
  if (!seen) return Unexpected<Error>(seen.error());
  return state_->planners.take(seen->space, seen->version, spec, count, deadline);
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
  auto made = state_->field.get(view.space, view.version, std::move(goals), moves, limits);
  if (!made) return Unexpected<PlanFailure>(std::move(made.error()));
  return Field{std::move(made->costs), made->metrics};
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
