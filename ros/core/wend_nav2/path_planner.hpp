// SPDX-License-Identifier: Apache-2.0
#pragma once

// PathPlanner: from the costs of a costmap, a start and a goal to the poses of a path. Keeps its planner and what it
// prepared warm between calls, and only repairs what the costmap changed. Knows no ROS; one thread at a time.
//
//   PathPlanner planner;
//   planner.set(settings);
//   planner.costmap().read(layout, costs);  // with the costmap's lock
//   const auto poses = planner.plan({start, goal, robot}, cancel_checker);
//   if (!poses) throw_as_nav2(poses.error());

#include <functional>
#include <utility>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/session/session.hpp"
#include "wend_nav2/costmap_copy.hpp"
#include "wend_nav2/failure.hpp"
#include "wend_nav2/planner_settings.hpp"
#include "wend_nav2/robot_shape.hpp"

namespace wend_nav2 {

/// In the costmap's frame.
struct PathRequest {
  wend::MapPose start = {};
  wend::MapPose goal = {};
  RobotShape robot = {};
};

class PathPlanner {
 public:
  using Poses = std::vector<wend::MapPose>;
  /// True once the caller wants no path any more.
  using CancelChecker = std::function<bool()>;

  PathPlanner();

  /// For the calls from now on.
  void set(PlannerSettings settings) { settings_ = std::move(settings); }
  const PlannerSettings& settings() const { return settings_; }

  CostmapCopy& costmap() { return costmap_; }

  /// Plans on the costs that were read last. If the goal cannot be reached, plans to the nearest of three distances
  /// up to the tolerance from which a path ends. The search is limited by the time limit, all tries together, and
  /// asks `cancelled`, unless it is empty, every few hundred expansions.
  wend::Expected<Poses, Failure> plan(const PathRequest& request, const CancelChecker& cancelled);

  /// How far the ends of the last path are from where they were asked to be; empty if they are there.
  const std::string& shifts() const { return shifts_; }

 private:
  struct Watch;

  wend::Expected<void, Failure> prepare(const RobotShape& robot);
  wend::Expected<Poses, Failure> plan_within(const PathRequest& request, double tolerance,
                                             Watch& watch, bool closest = false);
  wend::PlanRequest request_of(const PathRequest& request, double tolerance, Watch& watch,
                               bool closest) const;
  Poses poses_of(const wend::PlanAnswer& answer, const PathRequest& request) const;

  wend::Session session_;
  CostmapCopy costmap_;
  PlannerSettings settings_;
  std::string shifts_;
};

}  // namespace wend_nav2
