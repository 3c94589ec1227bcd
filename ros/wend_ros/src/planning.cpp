#include "wend_ros/planning.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "wend/base/thread_time.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/io/text.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/shift_text.hpp"
#include "wend/session/units.hpp"
#include "wend_ros/path_message.hpp"

namespace wend_ros {
namespace {

/// The planner of a request with all its options, or why it cannot be made.
wend::Expected<wend::PlannerSpec, wend::Error> spec_of(const Parameters& parameters,
                                                       const Ask& ask) {
  std::string text = ask.planner.empty() ? parameters.text("planner") : ask.planner;
  if (!ask.options.empty()) text += (text.find(':') == std::string::npos ? ":" : ",") + ask.options;
  auto specs = wend::parse_planner_specs(text);
  if (!specs) return wend::Unexpected(specs.error());
  if (specs->size() != 1) {
    return wend::Unexpected<wend::Error>(
        {wend::Status::invalid_option, "one planner expected, not " + wend::quote(text)});
  }
  wend::PlannerSpec spec = std::move(specs->front());
  // What the request says comes last, and so counts.
  wend::OptionValues options = parameters.options_of(spec.name);
  options.insert(options.end(), spec.options.begin(), spec.options.end());
  spec.options = std::move(options);
  return spec;
}

constexpr double kTrajectoryPeriod = 0.1;  // s
constexpr double kMostStamps = 1e5;

wend::TrajectoryLimits limits_of(const Parameters& parameters) {
  wend::OptionValues values;
  for (const wend::OptionInfo& limit : wend::option_schema<wend::TrajectoryLimits>()) {
    values.emplace_back(limit.name, parameters.text(limit.name));
  }
  return wend::parse_options<wend::TrajectoryLimits>(values).value_or(wend::TrajectoryLimits{});
}

wend::PlanRequest request_of(const Parameters& parameters, const Ask& ask, const Watch& watch,
                             wend::PlannerSpec planner, double resolution) {
  wend::PlanRequest request{.start = ask.start, .goals = {}};
  for (const wend::MapPose& goal : ask.goals) {
    wend::MapGoal& added = request.goals.emplace_back(wend::MapGoal{goal.point()});
    if (!ask.any_heading) added.heading = goal.heading;
  }
  for (const wend::RequestField* field : request_parameters()) {
    const auto value = field->info.number_of(parameters.text(field->info.name));
    if (value) field->put(request, *value, resolution);
  }
  request.planner = std::move(planner);
  request.limits.cancel = watch.cancel;
  const double limit = ask.time_limit > 0 ? ask.time_limit : parameters.number("time_limit");
  if (limit > 0) request.limits.seconds = limit;
  request.observer = watch.observer;
  request.on_solution = watch.on_solution;
  request.nearest = ask.nearest;
  request.closest = ask.closest;
  request.explain = ask.explain;
  request.from_field = ask.from_field;
  request.keep = ask.keep;
  request.trajectory = limits_of(parameters);
  return request;
}

bool is_of_cells(const std::string& planner) {
  const wend::PlannerInfo* info = wend::planners().find(planner);
  return info != nullptr && !info->capabilities.headings;
}

/// Grid planners' paths are smoothed; a drive is smooth as it is.
void refine_as_asked(wend::PlanRequest& request, const Parameters& parameters) {
  if (!parameters.flag("smooth") || !is_of_cells(request.planner.name)) return;
  request.refinement.smoother = wend::SmootherChoice{
      "gradient",
      {{"alpha", parameters.text("smooth_alpha")}, {"beta", parameters.text("smooth_beta")}}};
}

/// The goal at which a path ends: the one nearest to its end.
const wend::MapPose& goal_of(const Ask& ask, wend::MapPoint end) {
  return *std::ranges::min_element(
      ask.goals, {}, [&](const wend::MapPose& goal) { return distance(goal.point(), end); });
}

/// The trajectory, and the turn in place to a heading behind it.
nav_msgs::Path trajectory_message(const wend::Trajectory& trajectory, std::optional<double> heading,
                                  const wend::TrajectoryLimits& limits,
                                  const std::string& frame_id) {
  nav_msgs::Path message = to_message(trajectory, frame_id, kTrajectoryPeriod);
  const wend::MapPose end = trajectory.at(trajectory.duration()).pose;
  constexpr double kNoTurn = 1e-6;  // rad
  if (!heading || std::abs(wend::normalized_angle(*heading - end.heading)) < kNoTurn) {
    return message;
  }
  // Metres are the grid's units here.
  const auto turn = wend::Trajectory::along(
      wend::Path::through({{end.x, end.y, end.heading}, {end.x, end.y, *heading}}), wend::Frame{},
      limits);
  if (!turn) return message;
  const ros::Duration before(trajectory.duration());
  for (auto& stamped : to_message(*turn, frame_id, kTrajectoryPeriod).poses) {
    if (stamped.header.stamp.isZero()) continue;  // where the trajectory ends
    stamped.header.stamp += before;
    message.poses.push_back(std::move(stamped));
  }
  return message;
}

/// Paths of cells end with the heading of the goal, which followers turn to.
void put_heading(PlanResult& result, double heading) {
  result.path = ending_with(heading, std::move(result.path));
  result.smoothed = ending_with(heading, std::move(result.smoothed));
}

void put_answer(PlanResult& result, const wend::PlanAnswer& answer, const std::string& frame_id,
                const wend::TrajectoryLimits& limits, std::optional<double> heading) {
  const wend::Frame& frame = answer.space.map().frame();
  const wend::Plan& plan = answer.plan;
  result.status_name = to_string(StatusCode::found);
  result.path = to_message(plan.path, frame, frame_id);
  result.cost = plan.cost;
  result.bound = plan.bound;
  if (answer.lead_out) {
    result.lead_out = answer.lead_out->length;
    result.lead_out_poses = static_cast<std::uint32_t>(answer.lead_out->points);
  }
  result.remaining = answer.remaining.value_or(0);
  for (const std::string_view move : plan.moves) result.moves.emplace_back(move);
  result.path_metrics = metrics_message(plan.path, answer.space);
  if (answer.refined) result.smoothed = to_message(answer.refined->path, frame, frame_id);
  if (answer.trajectory && answer.trajectory->duration() / kTrajectoryPeriod <= kMostStamps) {
    result.trajectory = trajectory_message(*answer.trajectory, heading, limits, frame_id);
  }
  if (heading) put_heading(result, *heading);
  if (answer.fault) result.reason = "the path is as planned: " + answer.fault->message;
  const auto add = [&result](const std::string& note) {
    result.reason += (result.reason.empty() ? "" : "; ") + note;
  };
  std::ranges::for_each(answer.notes, add);
  const std::string shifts = wend::shifts_text(plan.start_snapping_error, plan.goal_snapping_error,
                                               wend::Units(answer.space.map()));
  if (!shifts.empty()) add(shifts);
}

void put_metrics(PlanResult& result, const wend::SearchMetrics& metrics, double seconds) {
  result.metrics.expanded = metrics.expanded;
  result.metrics.generated = metrics.generated;
  result.metrics.max_frontier = metrics.max_frontier;
  result.metrics.seconds = seconds;
}

}  // namespace

PlanResult refusal(StatusCode code, std::string reason) {
  PlanResult result;
  result.status = static_cast<std::uint16_t>(code);
  result.status_name = to_string(code);
  result.reason = std::move(reason);
  return result;
}

namespace {

/// Where to plan from and to instead, if an end is blocked. The reasons of planners on cells name their
/// nearest free cell already.
void put_nearest(PlanResult& result, const wend::Session& session, const wend::GridMap& map,
                 wend::Status status, const Ask& ask, bool of_cells) {
  const auto put = [&](auto& message, const std::string& name, const wend::MapPose& pose) {
    const auto free = session.nearest(pose);
    if (!free) return;
    message.push_back(to_message(*free));
    if (of_cells) return;
    result.reason += ". The nearest pose with this heading at which it fits is at " +
                     wend::Units(map).text(map.frame().to_grid(free->point())) + ": `" + name +
                     "` of the result";
  };
  if (status == wend::Status::start_blocked) put(result.nearest_start, "nearest_start", ask.start);
  if (status == wend::Status::goal_blocked) {
    put(result.nearest_goal, "nearest_goal", ask.goals.front());
  }
}

}  // namespace

wend::FreeSpaceOptions robot_of(const Parameters& parameters) {
  wend::FreeSpaceOptions robot;
  for (const wend::RobotField* field : robot_parameters()) {
    const auto value = field->info.number_of(parameters.text(field->info.name));
    if (value) field->put(robot, *value, 1);
  }
  robot.footprint = parameters.footprint();
  if (parameters.flag("unknown_free")) robot.unknown = wend::UnknownPolicy::free;
  robot.primitives = parameters.primitives();
  return robot;
}

wend::SessionOptions session_options() {
  return {.idle_planners = 4,
          .hints = {.unknown_free = "~unknown_free",
                    .outside_free = "~outside 'free'",
                    .squeeze = "~connectivity 8 and ~corner_rule both",
                    .robot_radius = "~robot_radius",
                    .nearest = "`nearest` in the request",
                    .nearest_limit = "~nearest_limit",
                    .escape = "~escape",
                    .limit_seconds = "~time_limit"},
          .clock = wend::thread_cpu_seconds};
}

Answer answer(wend::Session& session, const wend::Session::View& view, const Parameters& parameters,
              const Ask& ask, const Watch& watch) {
  const auto spec = spec_of(parameters, ask);
  if (!spec) return {refusal(code_of(spec.error().status), spec.error().message)};
  wend::PlanRequest request =
      request_of(parameters, ask, watch, *spec, view.space.map().frame().resolution);
  refine_as_asked(request, parameters);
  auto answered = ask.keep > 0 ? session.replan(view, request) : session.plan(view, request);
  PlanResult result;
  std::optional<double> heading;  // to turn to at the end
  if (answered && !ask.any_heading && is_of_cells(spec->name)) {
    const wend::Frame& frame = view.space.map().frame();
    heading = goal_of(ask, frame.to_metres(answered->plan.path.poses().back().point())).heading;
  }
  if (answered) {
    put_answer(result, *answered, view.frame_id, limits_of(parameters), heading);
    put_metrics(result, answered->plan.metrics, answered->search_seconds);
  } else {
    const wend::RequestFailure& failed = answered.error();
    result = refusal(code_of(failed.status), failed.message);
    put_nearest(result, session, view.space.map(), failed.status, ask, is_of_cells(spec->name));
    put_metrics(result, failed.metrics, failed.search_seconds);
  }
  result.from_field = request.from_field ? 1 : 0;
  if (!answered) return {std::move(result)};
  const wend::Frame& frame = answered->space.map().frame();
  nav_msgs::Path way = way_message(answered->plan.path, frame, view.frame_id);
  if (heading) way = ending_with(*heading, std::move(way));
  wend::Path driven = answered->path();
  return {std::move(result), std::move(answered->plan.path), std::move(driven), std::move(way)};
}

}  // namespace wend_ros
