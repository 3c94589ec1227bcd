#include "wend_ros/planning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/path/corner_rounding.hpp"
#include "wend/path/gradient_smoother.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/planners.hpp"
#include "wend_ros/path_message.hpp"

namespace wend_ros {
namespace {

constexpr std::size_t kMostIdle = 2;

/// The planner of a request with all its options, or why it cannot be made.
wend::Expected<wend::PlannerSpec, wend::Error> spec_of(const Parameters& parameters,
                                                       const Ask& ask) {
  std::string text = ask.planner.empty() ? parameters.text("planner") : ask.planner;
  if (!ask.options.empty()) text += (text.find(':') == std::string::npos ? ":" : ",") + ask.options;
  auto specs = wend::parse_planner_specs(text);
  if (!specs) return wend::Unexpected(specs.error());
  if (specs->size() != 1) {
    return wend::Unexpected<wend::Error>(
        {wend::Status::invalid_option, "one planner expected, not '" + text + "'"});
  }
  wend::PlannerSpec spec = std::move(specs->front());
  // What the request says comes last, and so counts.
  wend::OptionValues options = parameters.options_of(spec.name);
  options.insert(options.end(), spec.options.begin(), spec.options.end());
  spec.options = std::move(options);
  return spec;
}

/// Do all its points lie in cells that have numbers?
bool are_cells(const wend::Query& query) {
  constexpr double kMost = 1e9;
  const auto is_cell = [](wend::Point point) {
    return std::abs(point.x) < kMost && std::abs(point.y) < kMost;
  };
  return is_cell(query.start.point()) &&
         std::ranges::all_of(query.goals, [&](const auto& goal) { return is_cell(goal.point); });
}

std::string key_of(const wend::PlannerSpec& spec) {
  std::string key = spec.name;
  for (const auto& [name, value] : spec.options) key += "," + name + "=" + value;
  return key;
}

wend::Query query_of(const wend::Frame& frame, const Ask& ask) {
  wend::Query query{.start = frame.to_grid(ask.start), .goals = {}};
  for (const wend::Pose& goal : ask.goals) {
    const wend::Pose in_grid = frame.to_grid(goal);
    query.goals.push_back(ask.any_heading ? wend::Goal(in_grid.point()) : wend::Goal(in_grid));
  }
  return query;
}

constexpr double kTrajectoryPeriod = 0.1;  // s
constexpr double kMostStamps = 1e5;

wend::TrajectoryLimits limits_of(const Parameters& parameters) {
  return {.speed = parameters.number("speed"),
          .turn_rate = parameters.number("turn_rate"),
          .acceleration = parameters.number("acceleration"),
          .turn_acceleration = parameters.number("turn_acceleration"),
          .lateral_acceleration = parameters.number("lateral_acceleration")};
}

void put_trajectory(PlanResult& result, const MapSnapshot& map, const Parameters& parameters,
                    const wend::GridMoves& moves, const wend::Path& path) {
  if (path.empty()) return;
  const wend::Path rounded =
      wend::rounded_corners(path, map.space, wend::kCornerRounding, moves.adjacency());
  const auto trajectory =
      wend::Trajectory::along(rounded, map.space.map().frame(), limits_of(parameters));
  if (!trajectory || trajectory->duration() / kTrajectoryPeriod > kMostStamps) return;
  result.trajectory = to_message(*trajectory, map.frame_id, kTrajectoryPeriod);
}

void put_plan(PlanResult& result, const MapSnapshot& map, const Parameters& parameters,
              const wend::GridMoves& moves, const wend::Plan& plan) {
  const wend::Frame& frame = map.space.map().frame();
  result.path = to_message(plan.path, frame, map.frame_id);
  result.cost = plan.cost;
  result.bound = plan.bound;
  for (const std::string_view move : plan.moves) result.moves.emplace_back(move);
  result.path_metrics = metrics_message(plan.path, map.space);
  if (!parameters.flag("smooth") || plan.path.driven()) {
    put_trajectory(result, map, parameters, moves, plan.path);
    return;
  }
  const wend::GradientOptions options{
      .alpha = parameters.number("smooth_alpha"),
      .beta = parameters.number("smooth_beta"),
      .squeeze = moves.adjacency() == wend::Adjacency::edges_and_corners};
  const auto smoothed = wend::smooth_by_gradient(plan.path, map.space, options);
  put_trajectory(result, map, parameters, moves, smoothed ? smoothed->path : plan.path);
  if (smoothed) {
    result.smoothed = to_message(smoothed->path, frame, map.frame_id);
  } else {
    result.reason = "not smoothed: " + smoothed.error().message;
  }
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

std::unique_ptr<wend::Planner> Planning::take(std::uint64_t version, const std::string& spec) {
  const std::lock_guard lock(mutex_);
  std::erase_if(idle_, [&](const Warm& warm) { return warm.version != version; });
  for (auto warm = idle_.begin(); warm != idle_.end(); ++warm) {
    if (warm->spec != spec) continue;
    auto planner = std::move(warm->planner);
    idle_.erase(warm);
    return planner;
  }
  return nullptr;
}

void Planning::give_back(Warm warm) {
  const std::lock_guard lock(mutex_);
  if (idle_.size() >= kMostIdle) idle_.erase(idle_.begin());
  idle_.push_back(std::move(warm));
}

/// The field of costs to the goals, made once for a map, goals and moves.
std::shared_ptr<const wend::CostToGo> Planning::field_to(const MapSnapshot& map,
                                                         const std::vector<wend::Cell>& goals,
                                                         const wend::GridMoves& moves,
                                                         const wend::Limits& limits,
                                                         wend::PlanFailure& failure) {
  const std::lock_guard lock(mutex_);
  if (field_ && field_->version == map.version && field_->goals == goals &&
      field_->moves == moves) {
    return field_->costs;
  }
  auto made = wend::CostToGo::make(map.space, goals, moves, limits);
  if (!made) {
    failure = made.error();
    return nullptr;
  }
  failure.metrics = made->metrics();
  field_ =
      Field{map.version, goals, moves, std::make_shared<const wend::CostToGo>(*std::move(made))};
  return field_->costs;
}

PlanResult Planning::answer_from_field(const MapSnapshot& map, const Parameters& parameters,
                                       const wend::Query& query, const wend::GridMoves& moves) {
  std::vector<wend::Cell> goals;
  for (const wend::Goal& goal : query.goals) goals.push_back(wend::cell_at(goal.point));
  wend::PlanFailure failure{{wend::Status::found, {}}, {}};
  double seconds = 0;
  const auto field = wend::timed(wend::thread_cpu_seconds, seconds, [&] {
    return field_to(map, goals, moves, query.limits, failure);
  });
  const auto refused = [&](wend::Status status) {
    return refusal(code_of(status), std::string(wend::describe(status)));
  };
  PlanResult result;
  if (!field) {
    result = refused(failure.status);
  } else if (const auto plan = field->path_from(wend::cell_at(query.start.point())); !plan) {
    result = refused(plan.error().status);
  } else {
    result.status_name = to_string(StatusCode::found);
    put_plan(result, map, parameters, moves, *plan);
  }
  result.from_field = 1;
  put_metrics(result, failure.metrics, seconds);
  return result;
}

PlanResult Planning::answer(const MapSnapshot& map, const Parameters& parameters, const Ask& ask,
                            const Watch& watch) {
  const auto spec = spec_of(parameters, ask);
  if (!spec) return refusal(code_of(spec.error().status), spec.error().message);
  const std::string key = key_of(*spec);
  auto planner = take(map.version, key);
  if (!planner) {
    auto made = wend::make_planner(spec->name, map.space, spec->options);
    if (!made) return refusal(code_of(made.error().status), made.error().message);
    planner = *std::move(made);
  }
  wend::Query query = query_of(map.space.map().frame(), ask);
  query.observer = watch.observer;
  query.limits.cancel = watch.cancel;
  const double limit = ask.time_limit > 0 ? ask.time_limit : parameters.number("time_limit");
  if (limit > 0) query.limits.seconds = limit;

  if (ask.from_field) {
    const wend::PlannerInfo& info = *wend::planners().find(spec->name);
    const bool by_steps = info.state_kind == wend::StateKind::cell && !info.any_angle;
    if (by_steps && are_cells(query)) {
      return answer_from_field(map, parameters, query, wend::moves_of(*spec));
    }
    return refusal(StatusCode::unsupported_query,
                   "only planners from cell to cell answer from a field");
  }

  wend::Plan plan;
  double seconds = 0;
  const wend::Status status =
      wend::timed(wend::thread_cpu_seconds, seconds, [&] { return planner->plan(query, plan); });
  PlanResult result;
  if (status == wend::Status::found) {
    result.status_name = to_string(StatusCode::found);
    put_plan(result, map, parameters, wend::moves_of(*spec), plan);
  } else {
    const std::string reason = planner->reason(query, status);
    result = refusal(code_of(status), reason);
  }
  put_metrics(result, plan.metrics, seconds);
  give_back({map.version, key, std::move(planner)});
  return result;
}

}  // namespace wend_ros
