// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_planner.hpp"

#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "wend/planner/planners.hpp"
#include "wend/session/shift_text.hpp"
#include "wend_nav2/path_poses.hpp"
#include "wend_nav2/pose_faults.hpp"

namespace wend_nav2 {
namespace {

wend::SessionOptions session_options() {
  return {.idle_planners = 2,
          .hints = {.unknown_free = "allow_unknown: true",
                    .squeeze = "connectivity: \"8\" and corner_rule: both",
                    .robot_radius = "a robot_radius of the costmap of",
                    .nearest = "nearest: true",
                    .nearest_limit = "nearest_limit:",
                    .escape = "escape:",
                    .limit_seconds = "time_limit"}};
}

bool is_finite(const wend::MapPose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

wend::Capabilities capabilities_of(const std::string& planner) {
  const wend::PlannerInfo* info = wend::planners().find(planner);
  return info == nullptr ? wend::Capabilities{} : info->capabilities;
}

wend::Unexpected<Failure> no_path(FailureKind kind, std::string message) {
  return wend::Unexpected<Failure>(Failure{kind, std::move(message)});
}

/// May a path that ends near the goal be found where none to it was?
bool may_end_nearby(FailureKind kind) {
  return kind == FailureKind::goal_occupied || kind == FailureKind::no_valid_path;
}

}  // namespace

/// The time and the caller's patience of one call. The search reads its clock every few hundred expansions, on this
/// thread: there the caller is asked, too.
struct PathPlanner::Watch {
  const CancelChecker& cancelled;
  double end;  // on the steady clock
  std::atomic<bool> stop = false;

  double read() {
    if (cancelled && cancelled()) stop = true;
    return wend::steady_seconds();
  }
};

PathPlanner::PathPlanner() : session_(session_options()) {}

wend::Expected<PathPlanner::Poses, Failure> PathPlanner::plan(const PathRequest& request,
                                                              const CancelChecker& cancelled) {
  for (const wend::MapPose* pose : {&request.start, &request.goal}) {
    if (is_finite(*pose)) continue;
    return no_path(FailureKind::other,
                   std::string(pose == &request.start ? "the start " : "the goal ") +
                       place_of(*pose) + " contains NaN or infinity");
  }
  const double limit = settings_.request["time_limit"];
  Watch watch{
      .cancelled = cancelled,
      .end = limit > 0 ? wend::steady_seconds() + limit : std::numeric_limits<double>::infinity()};
  if (auto ready = prepare(request.robot); !ready) {
    return wend::Unexpected<Failure>(std::move(ready.error()));
  }
  auto exact = plan_within(request, 0, watch);
  const double tolerance = settings_.request["goal_tolerance"];
  if (exact || !may_end_nearby(exact.error().kind)) return exact;
  for (const double share : {0.25, 0.5, 1.0}) {
    if (tolerance == 0) break;
    auto near = plan_within(request, share * tolerance, watch);
    // What was cancelled or ran out of time has not shown that there is no path.
    if (near || !may_end_nearby(near.error().kind)) return near;
  }
  if (settings_.request["closest"] != 0) return plan_within(request, 0, watch, true);
  return exact;
}

wend::Expected<void, Failure> PathPlanner::prepare(const RobotShape& robot) {
  const PluginOptions& plugin = settings_.plugin;
  const ObstacleRule rule = rule_for(plugin.obstacles);
  wend::FreeSpaceOptions options = robot_for(rule, robot, plugin.allow_unknown);
  options.primitives = settings_.primitives;
  session_.set_robot(std::move(options));
  // Planners that do not know costs would refuse every inflated costmap.
  const double factor = capabilities_of(settings_.planner).terrain ? plugin.cost_factor : 0;
  const auto brought = costmap_.bring_to(session_, scale_for(rule, factor));
  if (!brought) return wend::Unexpected<Failure>(failure_of(brought.error()));
  return {};
}

wend::PlanRequest PathPlanner::request_of(const PathRequest& request, double tolerance,
                                          Watch& watch, bool closest) const {
  wend::PlanRequest made{
      .start = request.start,
      .goals = {{.point = request.goal.point(), .heading = request.goal.heading}},
      .planner = {settings_.planner, settings_.options},
      .limits = {.clock = [&watch] { return watch.read(); }, .cancel = &watch.stop}};
  settings_.request.put(made, 1);
  made.goals.front().tolerance = tolerance;
  made.closest = closest;
  // The failure of the query itself is what is reported. An explanation takes time.
  made.explain = made.explain && tolerance == 0;
  made.limits.seconds = watch.end - wend::steady_seconds();
  made.refinement.spacing.reset();  // poses_of() does it
  // Lines of any angle are taut: smoothing would cut their corners, where they touch obstacles.
  const wend::Capabilities& capabilities = capabilities_of(settings_.planner);
  if (settings_.plugin.smooth && !capabilities.headings && !capabilities.any_angle) {
    made.refinement.smoother = wend::SmootherChoice{};
  }
  return made;
}

wend::Expected<PathPlanner::Poses, Failure> PathPlanner::plan_within(const PathRequest& request,
                                                                     double tolerance, Watch& watch,
                                                                     bool closest) {
  const double now = watch.read();
  if (watch.stop) return no_path(FailureKind::cancelled, "planning was cancelled");
  if (now >= watch.end) {
    return no_path(FailureKind::timed_out, "the time limit passed before the search");
  }
  const wend::PlanRequest made = request_of(request, tolerance, watch, closest);
  const auto answer = settings_.plugin.replan ? session_.replan(made) : session_.plan(made);
  if (!answer) {
    return wend::Unexpected<Failure>(
        Failure{kind_of(answer.error().status), answer.error().message});
  }
  shifts_ = wend::shifts_text(answer->plan.start_snapping_error, answer->plan.goal_snapping_error,
                              wend::Units(answer->space.map()));
  return poses_of(*answer, request);
}

PathPlanner::Poses PathPlanner::poses_of(const wend::PlanAnswer& answer,
                                         const PathRequest& request) const {
  const wend::Frame& frame = answer.space.map().frame();
  const double asked = settings_.request["spacing"];
  const double spacing = asked > 0 ? asked : frame.resolution;
  const wend::Path& path = answer.path();
  if (path.driven()) return poses_along(path, frame, spacing);
  const wend::Adjacency adjacency = answer.moves.value_or(wend::GridMoves{}).adjacency();
  Poses poses = poses_along(
      with_exact_ends(path, answer.space, adjacency, request.start, request.goal), frame, spacing);
  poses.back().heading = request.goal.heading;
  return poses;
}

}  // namespace wend_nav2
