#include "wend/session/session.hpp"

#include <algorithm>
#include <utility>

#include "wend/base/mutex.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/session/kept_field.hpp"
#include "wend/session/kept_plan.hpp"
#include "wend/session/nearest_ends.hpp"
#include "wend/session/resuming.hpp"
#include "wend/session/run_parts.hpp"

namespace wend {
namespace {

Unexpected<RequestFailure> no_plan(Error error) {
  return Unexpected<RequestFailure>(RequestFailure{PlanFailure{std::move(error), {}}});
}

bool is_stopped(Status status) {
  return status == Status::time_limit || status == Status::cancelled;
}

/// The copy constructor of tl::expected is noexcept: it would end the program where there is no memory.
Expected<Session::View, Error> copy_of(const Expected<Session::View, Error>& view) {
  if (!view) return Unexpected<Error>(view.error());
  return Session::View(*view);
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

  /// What a run of a request gets, on this planner.
  RunParts run_parts(const View& view, WarmPlanner planner, PlannerSpec spec,
                     const PlanRequest& request, Deadline deadline) const {
    return {view.space,          view.version,  std::move(planner), std::move(spec), request,
            std::move(deadline), options.hints, options.clock,      field,           nullptr};
  }
  /// The same on a warm planner.
  Expected<RunParts, RequestFailure> run_parts(const View& view, PlannerSpec spec,
                                               const PlanRequest& request,
                                               const Deadline& deadline);
  /// Answers a request with a planner that stays the caller's.
  Expected<PlanAnswer, RequestFailure> answer(const View& view, WarmPlanner& planner,
                                              const PlannerSpec& spec, const PlanRequest& request);

  /// Makes the free space if map or robot have changed. Who needs the same one waits; nobody else does.
  Expected<View, Error> view(const Deadline& deadline = {});

  // Called with the lock.
  std::optional<Expected<View, Error>> known_view() const;
  Expected<SpaceChange, Error> edit_view(View& view, const MapEdit& edit, const Deadline& deadline);
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

  const std::shared_ptr<KeptField> field =
      std::make_shared<KeptField>();  // of costs; has a lock of its own
  const std::shared_ptr<KeptPlan> kept = std::make_shared<KeptPlan>();  // the same
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

Expected<SpaceChange, Error> Session::edit(const MapEdit& edit, const Deadline& deadline) {
  State& state = *state_;
  for (;;) {
    if (const auto seen = state.view(deadline); !seen) return Unexpected<Error>(seen.error());
    const MutexLock lock(state.mutex);
    // Map and robot may have been replaced meanwhile.
    if (state.kept_view && *state.kept_view)
      return state.edit_view(**state.kept_view, edit, deadline);
  }
}

Expected<SpaceChange, Error> Session::State::edit_view(View& view, const MapEdit& edit,
                                                       const Deadline& deadline) {
  if (auto fault = fault_of(edit, view.space.map())) return Unexpected<Error>(*std::move(fault));
  // Whatever shares the space would make the edit copy it.
  map.reset();
  obstacles.reset();
  field->forget();
  auto idle = planners.release(version);
  auto change = view.space.edit(edit, deadline);
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

Expected<RunParts, RequestFailure> Session::State::run_parts(const View& view, PlannerSpec spec,
                                                             const PlanRequest& request,
                                                             const Deadline& deadline) {
  if (request.observer != nullptr) spec = without_leaps(std::move(spec));
  auto planner = planners.take(view.space, view.version, spec, deadline);
  if (!planner) return no_plan(std::move(planner.error()));
  return run_parts(view, *std::move(planner), std::move(spec), request, deadline);
}

Expected<PlanAnswer, RequestFailure> Session::State::answer(const View& view, WarmPlanner& planner,
                                                            const PlannerSpec& spec,
                                                            const PlanRequest& request) {
  RunParts parts = run_parts(view, std::move(planner), spec, request, Deadline(request.limits));
  auto run = SearchRun::begin(parts);
  if (!run) {
    planner = std::move(parts.planner);
    return Unexpected<RequestFailure>(std::move(run.error()));
  }
  auto answer = run->finish();
  planner = run->take_planner();
  return answer;
}

Expected<SearchRun, RequestFailure> Session::begin(const PlanRequest& request) {
  const Deadline deadline(request.limits);
  auto seen = view(deadline);
  if (!seen) return no_plan(std::move(seen.error()));
  return begin(*seen, request, deadline);
}

Expected<SearchRun, RequestFailure> Session::begin(const View& view, const PlanRequest& request) {
  return begin(view, request, Deadline(request.limits));
}

Expected<SearchRun, RequestFailure> Session::begin(const View& view, const PlanRequest& request,
                                                   const Deadline& deadline) {
  auto parts = state_->run_parts(view, request.planner, request, deadline);
  if (!parts) return Unexpected<RequestFailure>(std::move(parts.error()));
  return SearchRun::begin(*parts);
}

Expected<PlanAnswer, RequestFailure> Session::plan(const PlanRequest& request) {
  auto run = begin(request);
  if (!run) return Unexpected<RequestFailure>(std::move(run.error()));
  return run->finish();
}

Expected<PlanAnswer, RequestFailure> Session::plan(const View& view, const PlanRequest& request) {
  auto run = begin(view, request);
  if (!run) return Unexpected<RequestFailure>(std::move(run.error()));
  return run->finish();
}

/// An index is not built to explain: planners with one move as astar does.
std::string Session::explain(const View& view, const PlanRequest& request,
                             const PlanFailure& failure, const Deadline& deadline) {
  const PlannerInfo* const info = wend::planners().find(request.planner.name);
  if (info == nullptr || failure.status == Status::index_mismatch) return failure.message;
  PlanRequest asked = request;
  asked.observer = nullptr;
  if (info->index_support) asked.planner = PlannerSpec{"astar"};
  auto run = begin(view, asked, deadline);
  return run ? run->explain(failure) : failure.message;
}

Expected<PlanAnswer, RequestFailure> Session::replan(const PlanRequest& request) {
  const Deadline deadline(request.limits);
  auto seen = view(deadline);
  if (!seen) return no_plan(std::move(seen.error()));
  return replan(*seen, request, deadline);
}

Expected<PlanAnswer, RequestFailure> Session::replan(const View& view, const PlanRequest& request) {
  return replan(view, request, Deadline(request.limits));
}

Expected<PlanAnswer, RequestFailure> Session::replan(const View& view, const PlanRequest& request,
                                                     const Deadline& deadline) {
  auto parts = state_->run_parts(view, resuming(request.planner, view.space), request, deadline);
  if (!parts) return Unexpected<RequestFailure>(std::move(parts.error()));
  parts->kept = state_->kept;
  auto run = SearchRun::begin(*parts);
  if (!run) return Unexpected<RequestFailure>(std::move(run.error()));
  return run->finish();
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
  workers.run(requests.size(), [&](std::size_t i, unsigned worker) {
    answers[i] = state_->answer(*seen, (*planners)[worker], planner, requests[i]);
  });
  return answers;
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
  auto made = state_->field->get(view.space, view.version, std::move(goals), moves, limits);
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
