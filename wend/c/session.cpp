// Sessions of the C interface: where the robot fits, plans and fields.

#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/c/boundary.hpp"
#include "wend/c/objects.hpp"
#include "wend/c/request.hpp"
#include "wend/planner/goal_region.hpp"

wend_session::wend_session(const wend::GridMap& first_map, const wend::Robot& robot,
                           const wend::ObstacleOptions& chosen)
    : obstacles(chosen), session(first_map, options_of(robot)), map(first_map) {}

wend::FreeSpaceOptions wend_session::options_of(const wend::Robot& robot) const {
  return {.footprint = robot.footprint,
          .unknown = obstacles.unknown,
          .outside = obstacles.outside,
          .clearance_distance = robot.clearance_distance,
          .clearance_cost = robot.clearance_cost};
}

void wend_session::set_map(const wend::GridMap& next) {
  const std::scoped_lock lock(mutex);
  map = next;
  session.set_map(next);
}

wend::Expected<void, wend::Error> wend_session::edit(const wend::MapEdit& edit) {
  const std::scoped_lock lock(mutex);
  map.reset();
  const auto change = session.edit(edit);
  const auto view = session.view();
  if (view) map = view->space.map();
  if (!change) return wend::Unexpected<wend::Error>(change.error());
  return {};
}

void wend_session::drop_planners() {
  const std::scoped_lock lock(mutex);
  if (map) {
    session.set_map(*map);
  } else {
    session.clear_map("an edit of the map was stopped: set the map again");
  }
}

namespace wend::c {
namespace {

using Done = Expected<void, Failure>;
using SessionResult = Expected<std::unique_ptr<wend_session>, Failure>;
using RequestResult = Expected<PlanRequest, Failure>;

constexpr wend_session_options kSessionDefaults{sizeof(wend_session_options), WEND_POLICY_DEFAULT,
                                                WEND_POLICY_DEFAULT};

MapPose map_pose(const wend_pose& pose) { return {pose.x, pose.y, pose.heading}; }

Robot robot_or_point(const wend_robot* robot) { return robot == nullptr ? Robot{} : robot->robot; }

Expected<ObstacleOptions, Failure> obstacles_of(const wend_session_options& options) {
  for (const std::int32_t policy : {options.unknown, options.outside}) {
    if (policy < WEND_POLICY_DEFAULT || policy > WEND_POLICY_FREE) {
      return refused("wend_session_options has the policy " + std::to_string(policy) +
                     ", not a value of wend_policy");
    }
  }
  ObstacleOptions obstacles;
  if (options.unknown == WEND_POLICY_FREE) obstacles.unknown = UnknownPolicy::free;
  if (options.outside == WEND_POLICY_FREE) obstacles.outside = OutsidePolicy::free;
  if (options.outside == WEND_POLICY_BLOCKED) obstacles.outside = OutsidePolicy::blocked;
  return obstacles;
}

RequestResult plan_request_of(const wend_request* given, double resolution) {
  auto asked = request_of(given, resolution);
  if (!asked) return asked;
  if (!is_finite(given->start)) return refused("wend_request.start contains NaN or infinity");
  asked->start = map_pose(given->start);
  return asked;
}

/// Session::plan() or Session::replan() on a view.
using PlanOnView = Expected<PlanAnswer, RequestFailure> (Session::*)(const Session::View&,
                                                                     const PlanRequest&);

/// Tells the caller each path. `enough` is set, and ends the search, when the caller says so.
void tell_solutions(const wend_request& request, const FreeSpace& space, std::atomic<bool>& enough,
                    PlanRequest& asked) {
  asked.on_solution = [&](const Plan& plan) {
    const wend_plan told(PlanAnswer{.space = space, .plan = plan});
    if (request.on_solution(&told, request.context) != 0) enough = true;
  };
  if (const std::atomic<bool>* cancel = asked.limits.cancel) {
    asked.limits.clock = [cancel, &enough] {
      if (*cancel) enough = true;
      return steady_seconds();
    };
  }
  asked.limits.cancel = &enough;
}

Expected<std::unique_ptr<wend_plan>, Failure> make_plan(wend_session& handle,
                                                        const wend_request* request,
                                                        PlanOnView plan_on) {
  const auto view = handle.session.view();
  if (!view) return failed(view.error());
  auto asked = plan_request_of(request, view->space.map().frame().resolution);
  if (!asked) return Unexpected<Failure>(asked.error());
  std::atomic<bool> enough = false;
  if (request->on_solution != nullptr) tell_solutions(*request, view->space, enough, *asked);
  const auto answer = (handle.session.*plan_on)(*view, *asked);
  if (!answer) return failed(static_cast<const PlanFailure&>(answer.error()));
  if (answer->fault) return failed(*answer->fault);
  return std::make_unique<wend_plan>(*answer);
}

wend_status plan_by(wend_session* session, const wend_request* request, wend_plan** plan,
                    wend_error* error, PlanOnView plan_on) {
  return made("plan", plan, error, [&]() -> Expected<std::unique_ptr<wend_plan>, Failure> {
    if (session == nullptr) return refused("session is null");
    return or_without_planners(*session, [&] { return make_plan(*session, request, plan_on); });
  });
}

/// Why there is no field: for a goal that is outside or blocked, which and why.
Failure no_field(PlanFailure failure, const FreeSpace& space, const Query& query) {
  if (failure.status == Status::goal_outside || failure.status == Status::goal_blocked) {
    const Units units(space.map());
    const Explainer explainer(space, units, {}, {});
    for (const Goal& goal : query.goals) {
      std::string why = explainer.blocked(units.place("goal", goal.point));
      if (!why.empty()) failure.message = std::move(why);
    }
  }
  return failure_of(std::move(failure));
}

Expected<std::unique_ptr<wend_field>, Failure> make_field(wend_session& handle,
                                                          const wend_request* request) {
  const auto view = handle.session.view();
  if (!view) return failed(view.error());
  const auto asked = request_of(request, view->space.map().frame().resolution);
  if (!asked) return Unexpected<Failure>(asked.error());
  const auto planner = handle.session.planner(asked->planner);
  if (!planner) return failed(planner.error());
  const auto moves = (*planner)->grid_moves();
  if (!moves || planners().find(asked->planner.name)->capabilities.any_angle) {
    return failed(Error{Status::unsupported_query,
                        asked->planner.name + " does not step from cell to cell: it has no field"});
  }
  const Query query = query_of(*asked, view->space.map().frame());
  auto field =
      handle.session.cost_to_go(*view, goal_cells(view->space, query), *moves, asked->limits);
  if (!field) {
    return Unexpected<Failure>(no_field(std::move(field.error()), view->space, query));
  }
  return std::make_unique<wend_field>(view->space, *std::move(field));
}

/// Checks the arguments of a question about a pose, and asks it.
template <class Ask>
wend_status ask_at(wend_session* session, const wend_pose* pose, bool has_answer, wend_error* error,
                   const Ask& ask) {
  return guarded(error, [&]() -> Done {
    if (session == nullptr) return refused("session is null");
    if (pose == nullptr) return refused("pose is null");
    if (!has_answer) return refused("the pointer for the answer is null");
    if (!is_finite(*pose)) return refused("pose contains NaN or infinity");
    return or_without_planners(*session, ask);
  });
}

}  // namespace
}  // namespace wend::c

using namespace wend::c;

wend_status wend_session_options_init(wend_session_options* options, size_t struct_size) {
  return init(options, struct_size, kSessionDefaults);
}

wend_status wend_session_create(const wend_map* map, const wend_robot* robot,
                                const wend_session_options* options, wend_session** session,
                                wend_error* error) {
  return made("session", session, error, [&]() -> SessionResult {
    if (map == nullptr) return refused("map is null");
    const auto chosen = wend::c::options_of("wend_session_options", options, kSessionDefaults);
    if (!chosen) return wend::Unexpected<Failure>(chosen.error());
    const auto obstacles = obstacles_of(*chosen);
    if (!obstacles) return wend::Unexpected<Failure>(obstacles.error());
    return std::make_unique<wend_session>(map->map, robot_or_point(robot), *obstacles);
  });
}

wend_status wend_session_set_map(wend_session* session, const wend_map* map, wend_error* error) {
  return guarded(error, [&]() -> Done {
    if (session == nullptr) return refused("session is null");
    if (map == nullptr) return refused("map is null");
    session->set_map(map->map);
    return {};
  });
}

wend_status wend_session_set_robot(wend_session* session, const wend_robot* robot,
                                   wend_error* error) {
  return guarded(error, [&]() -> Done {
    if (session == nullptr) return refused("session is null");
    session->session.set_robot(session->options_of(robot_or_point(robot)));
    return {};
  });
}

wend_status wend_session_fits(wend_session* session, const wend_pose* pose, int32_t* fits,
                              wend_error* error) {
  return ask_at(session, pose, fits != nullptr, error, [&]() -> Done {
    const auto view = session->session.view();
    if (!view) return failed(view.error());
    const wend::Pose asked = view->space.map().frame().to_grid(map_pose(*pose));
    *fits = view->space.fits(asked) ? 1 : 0;
    return {};
  });
}

wend_status wend_session_nearest(wend_session* session, const wend_pose* pose, wend_pose* nearest,
                                 wend_error* error) {
  return ask_at(session, pose, nearest != nullptr, error, [&]() -> Done {
    const auto found = session->session.nearest(map_pose(*pose));
    if (!found) return failed(found.error());
    *nearest = {found->x, found->y, found->heading};
    return {};
  });
}

void wend_session_free(wend_session* session) { delete session; }

wend_status wend_cancel_create(wend_cancel** cancel, wend_error* error) {
  return made("cancel", cancel, error,
              []() -> wend::Expected<std::unique_ptr<wend_cancel>, Failure> {
                return std::make_unique<wend_cancel>();
              });
}

void wend_cancel_set(wend_cancel* cancel, int32_t set) {
  if (cancel != nullptr) cancel->flag = set != 0;
}

void wend_cancel_free(wend_cancel* cancel) { delete cancel; }

wend_status wend_session_plan(wend_session* session, const wend_request* request, wend_plan** plan,
                              wend_error* error) {
  return plan_by(session, request, plan, error, &wend::Session::plan);
}

wend_status wend_session_replan(wend_session* session, const wend_request* request,
                                wend_plan** plan, wend_error* error) {
  return plan_by(session, request, plan, error, &wend::Session::replan);
}

wend_status wend_session_field(wend_session* session, const wend_request* request,
                               wend_field** field, wend_error* error) {
  return made("field", field, error, [&]() -> wend::Expected<std::unique_ptr<wend_field>, Failure> {
    if (session == nullptr) return refused("session is null");
    return or_without_planners(*session, [&] { return make_field(*session, request); });
  });
}
