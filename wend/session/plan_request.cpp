#include "wend/session/plan_request.hpp"

#include <cmath>
#include <utility>

#include "wend/geometry/angle.hpp"
#include "wend/path/joins.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/path/smoothing/corner_rounding.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/session/eased_query.hpp"

namespace wend {
namespace {

/// The turn in place from the end of one drive to the beginning of another, as poses; the way round that fits.
std::vector<Pose> turn_to(const Pose& end, double heading, const FreeSpace& space) {
  const TurnInPlace turn = turn_between(space, end.point(), end.heading, heading);
  const Pose half{end.x, end.y, normalized_angle(end.heading + turn.angle / 2)};
  return {end, half, {end.x, end.y, heading}};
}

/// A leg as it is driven at a stop at its beginning: with the turn from the heading in which the robot stands there.
/// Nothing if it goes nowhere.
std::optional<Path> driven_from(const std::optional<Pose>& stop, const Path& rounded,
                                const FreeSpace& space) {
  const auto poses = rounded.driven_poses();
  if (poses.size() < 2) return std::nullopt;
  constexpr double kStraight = 1e-9;  // radians
  const double heading = poses.front().heading;
  if (!stop || std::abs(normalized_angle(heading - stop->heading)) <= kStraight) return rounded;
  std::vector<Pose> driven = turn_to(*stop, heading, space);
  driven.insert(driven.end(), poses.begin() + 1, poses.end());
  return Path::through(std::move(driven));
}

/// Puts the lead before both paths of an answer.
void begin_with(const Path& lead, PlanAnswer& answer) {
  if (lead.empty()) return;
  begin_with(lead, answer.plan, answer.space.map().frame());
  const std::size_t before = lead.size() - 1;
  for (std::size_t i = 0; i < answer.legs.size(); ++i) {
    if (i > 0) answer.legs[i].first += before;  // the first leg begins with the lead
    answer.legs[i].last += before;
  }
  if (!answer.refined) return;
  answer.refined->path = joined(lead, answer.refined->path);
  for (std::size_t& join : answer.refined->joins) join += before;
}

}  // namespace

std::vector<MapPose> PlanAnswer::poses() const {
  const Frame& frame = space.map().frame();
  std::vector<MapPose> metres;
  for (const Pose& pose : path().poses()) metres.push_back(frame.to_metres(pose));
  return metres;
}

std::vector<Goal> goals_in_grid(std::span<const MapGoal> goals, MapUnits units,
                                const Frame& frame) {
  const bool given = units == MapUnits::cells;  // as a query has them
  std::vector<Goal> in_grid;
  for (const MapGoal& goal : goals) {
    const double heading = goal.heading.value_or(0);
    Goal& added =
        in_grid.emplace_back(given ? Pose{goal.point.x, goal.point.y, heading}
                                   : frame.to_grid(MapPose{goal.point.x, goal.point.y, heading}));
    if (!goal.heading) added.heading.reset();
    added.tolerance = given ? goal.tolerance : goal.tolerance / frame.resolution;
    added.heading_tolerance = goal.heading_tolerance;
  }
  return in_grid;
}

Query query_of(const PlanRequest& request, const Frame& frame) {
  const MapPose& start = request.start;
  return {request.coordinates == MapUnits::cells ? Pose{start.x, start.y, start.heading}
                                                 : frame.to_grid(start),
          goals_in_grid(request.goals, request.coordinates, frame), request.limits,
          request.observer, request.on_solution};
}

std::vector<std::size_t> PlanAnswer::joins() const {
  if (refined) return refined->joins;
  std::vector<std::size_t> joins;
  for (std::size_t i = 1; i < legs.size(); ++i) joins.push_back(legs[i].first);
  return joins;
}

Expected<Trajectory, Error> timed_path(const Path& path, const FreeSpace& space,
                                       Adjacency adjacency, const TrajectoryLimits& limits,
                                       double corner_rounding, const Deadline& deadline) {
  const auto rounded = rounded_corners(path, space, corner_rounding, adjacency, deadline);
  if (!rounded) return Unexpected<Error>(rounded.error());
  return Trajectory::along(*rounded, space.map().frame(), limits, deadline);
}

Expected<Trajectory, Error> timed_path(const Path& path, const FreeSpace& space,
                                       Adjacency adjacency, const TrajectoryLimits& limits,
                                       double corner_rounding, std::span<const std::size_t> stops,
                                       const Deadline& deadline) {
  if (stops.empty()) return timed_path(path, space, adjacency, limits, corner_rounding, deadline);
  if (auto fault = fault_of_joins(stops, path.size())) return Unexpected<Error>(*std::move(fault));
  const Frame& frame = space.map().frame();
  std::vector<Trajectory> legs;
  std::optional<Pose> stop;
  for (const Path& leg : legs_between(path, stops)) {
    const auto rounded = rounded_corners(leg, space, corner_rounding, adjacency, deadline);
    if (!rounded) return Unexpected<Error>(rounded.error());
    const auto driven = driven_from(stop, *rounded, space);
    if (!driven) continue;
    auto timed = Trajectory::along(*driven, frame, limits, deadline);
    if (!timed) return timed;
    legs.push_back(*std::move(timed));
    stop = driven->driven_poses().back();
  }
  if (legs.empty()) return timed_path(path, space, adjacency, limits, corner_rounding, deadline);
  return Trajectory::in_a_row(legs);
}

void finish_path(PlanAnswer& answer, const PlanRequest& request, const Path& lead,
                 const Deadline& deadline) {
  Refinement refinement = request.refinement;
  refinement.adjacency = answer.moves.value_or(GridMoves{}).adjacency();
  refinement.joins = answer.joins();
  if (refinement.simplify || refinement.smoother || refinement.spacing) {
    auto refined = wend::refined(answer.plan.path, answer.space, refinement, deadline);
    if (refined) {
      answer.refined = *std::move(refined);
    } else {
      answer.fault = std::move(refined.error());
    }
  }
  begin_with(lead, answer);
  if (!request.trajectory) return;
  const std::vector<std::size_t> stops =
      request.stops_at_vias ? answer.joins() : std::vector<std::size_t>{};
  auto trajectory = timed_path(answer.path(), answer.space, refinement.adjacency,
                               *request.trajectory, request.corner_rounding, stops, deadline);
  if (trajectory) {
    answer.trajectory = *std::move(trajectory);
  } else if (!answer.fault) {
    answer.fault = std::move(trajectory.error());
  }
}

}  // namespace wend
