#include "wend/session/plan_request.hpp"

#include "wend/path/smoothing/corner_rounding.hpp"
#include "wend/session/eased_query.hpp"

namespace wend {

std::vector<MapPose> PlanAnswer::poses() const {
  const Frame& frame = space.map().frame();
  std::vector<MapPose> metres;
  for (const Pose& pose : path().poses()) metres.push_back(frame.to_metres(pose));
  return metres;
}

Query query_of(const PlanRequest& request, const Frame& frame) {
  const bool given = request.coordinates == MapUnits::cells;  // as a query has them
  const auto in_grid = [&](const MapPose& pose) {
    return given ? Pose{pose.x, pose.y, pose.heading} : frame.to_grid(pose);
  };
  Query query{in_grid(request.start), {}, request.limits, request.observer, request.on_solution};
  for (const MapGoal& goal : request.goals) {
    const MapPose pose{goal.point.x, goal.point.y, goal.heading.value_or(0)};
    Goal& added = query.goals.emplace_back(in_grid(pose));
    if (!goal.heading) added.heading.reset();
    added.tolerance = given ? goal.tolerance : goal.tolerance / frame.resolution;
    added.heading_tolerance = goal.heading_tolerance;
  }
  return query;
}

Expected<Trajectory, Error> timed_path(const Path& path, const FreeSpace& space,
                                       Adjacency adjacency, const TrajectoryLimits& limits,
                                       double corner_rounding, const Deadline& deadline) {
  const auto rounded = rounded_corners(path, space, corner_rounding, adjacency, deadline);
  if (!rounded) return Unexpected<Error>(rounded.error());
  return Trajectory::along(*rounded, space.map().frame(), limits, deadline);
}

void finish_path(PlanAnswer& answer, const PlanRequest& request, const Path& lead,
                 const Deadline& deadline) {
  Refinement refinement = request.refinement;
  refinement.adjacency = answer.moves.value_or(GridMoves{}).adjacency();
  if (refinement.simplify || refinement.smoother || refinement.spacing) {
    auto refined = wend::refined(answer.plan.path, answer.space, refinement, deadline);
    if (refined) {
      answer.refined = *std::move(refined);
    } else {
      answer.fault = std::move(refined.error());
    }
  }
  begin_with(lead, answer.plan, answer.space.map().frame());
  if (!lead.empty() && answer.refined) answer.refined->path = joined(lead, answer.refined->path);
  if (!request.trajectory) return;
  auto trajectory = timed_path(answer.path(), answer.space, refinement.adjacency,
                               *request.trajectory, request.corner_rounding, deadline);
  if (trajectory) {
    answer.trajectory = *std::move(trajectory);
  } else if (!answer.fault) {
    answer.fault = std::move(trajectory.error());
  }
}

}  // namespace wend
