// The snippets of the headers of control and of the polylines that robots follow, compiled and run as they
// stand there.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/snippets/snippets.hpp"
#include "wend/control/follower.hpp"
#include "wend/control/given_route.hpp"
#include "wend/control/joining.hpp"
#include "wend/control/nearest_ahead.hpp"
#include "wend/control/pid.hpp"
#include "wend/control/simulation.hpp"
#include "wend/control/speed_profile.hpp"
#include "wend/control/trajectory_tracker.hpp"
#include "wend/path/gears.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/polyline.hpp"
#include "wend/path/smoothing/corner_rounding.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/planners.hpp"

namespace {

using wend::test::open_ground;
using wend::test::report;
using wend::test::reported;

TEST(Snippets, OfPolylineAndNearestAhead) {
  const wend::Polyline line({{0, 0}, {3, 0}, {3, 4}});
  const wend::Pose middle = line.at(5);                                     // (3,2), heading up y
  const wend::OnPolyline nearest = line.nearest({2, 1}, 0, line.length());  // (2,0), 2 along
  EXPECT_EQ(middle, (wend::Pose{3, 2, wend::kPi / 2}));
  EXPECT_EQ(nearest.along, 2);

  const wend::Polyline there_and_back({{0, 0}, {9, 0}, {0, 0}});
  const wend::OnPolyline there = wend::nearest_ahead(there_and_back, {4, 0, 0}, {0, 18, 1});
  EXPECT_EQ(there.along, 4);
}

TEST(Snippets, OfCornerRoundingAndSpeedProfile) {
  const wend::Corner corner({0, 0}, {1, 0}, {1, 1});
  const double radius = corner.radius(0.1);  // 0.24: 0.1 / (sqrt(2) - 1)
  EXPECT_NEAR(radius, 0.24, 0.002);

  const wend::MapPolyline line({{0, 0}, {3, 0}, {3, 4}});
  const double along = 1;
  const wend::SpeedProfile profile(line, {.lateral_acceleration = 1, .window = 0.2});
  const double fastest = profile.at(along);
  EXPECT_EQ(fastest, wend::VelocityLimits{}.speed);
}

TEST(Snippets, OfMotionModelAndPidTerm) {
  wend::RobotState robot{{0, 0, 0}};
  const wend::Step step = wend::drive(wend::MotionModel{}, robot, {0.3, 0.1}, 0.05);
  robot = step.to;
  EXPECT_EQ(robot.velocity.linear, 0.05) << "as fast as the acceleration allows";

  const double error = 0.2;
  const double change = 0;
  wend::PidTerm heading({.proportional = 3, .integral = 0.2, .derivative = 0.1}, 0.1);
  const double turn_rate = heading.output(error, change, 0.05, 1.5);
  EXPECT_NEAR(turn_rate, 3 * 0.2 + 0.2 * 0.2 * 0.05, 1e-12);
}

TEST(Snippets, OfGears) {
  const auto plan = wend::make_planner("hybrid_astar", open_ground())
                        .value()
                        ->plan({{4.5, 2.5, 0}, {wend::Goal(wend::Pose{2.5, 2.5, 0})}});
  ASSERT_TRUE(plan);
  const std::vector<int> gears = wend::gears_of(plan->path);
  const bool reverses = std::ranges::count(gears, -1) > 0;
  EXPECT_TRUE(reverses);
}

TEST(Snippets, OfCornersTrajectoryAndTracker) {
  const wend::FreeSpace& space = open_ground();
  const auto plan =
      wend::make_planner("astar", space).value()->plan(wend::Query::between({1, 1}, {8, 5}));
  ASSERT_TRUE(plan);
  const auto curve = wend::rounded_corners(plan->path, space, 0.1);
  [&] {
    if (!curve) return report(curve.error().message);
  }();
  ASSERT_TRUE(curve);
  const wend::Path& path = *curve;
  const wend::Frame& frame = space.map().frame();

  const wend::TrajectoryLimits limits{.speed = 0.4, .acceleration = 0.5};
  const auto trajectory = wend::Trajectory::along(path, frame, limits);
  const auto reported_or_half = [&] {
    if (!trajectory) return report(trajectory.error().message);
    const wend::TrajectoryState state = trajectory->at(trajectory->duration() / 2);
    EXPECT_GT(state.speed, 0.3);
  };
  reported_or_half();

  wend::TrajectoryTracker tracker(*trajectory);
  const wend::Drive tracked = wend::simulate(space, path, tracker);
  EXPECT_EQ(tracked.outcome, wend::DriveOutcome::reached);
}

struct WheeledRobot {
  void go(const wend::Velocity& velocity) { told = velocity; }
  wend::Velocity told{};
};

TEST(Snippets, OfControllerRouteAndFollower) {
  const auto made = [&] {
    const auto controller = wend::make_controller("pure_pursuit", {{"lookahead", "0.5"}});
    if (!controller) report(controller.error().message);
    return controller.has_value();
  };
  EXPECT_TRUE(made());

  const wend::FreeSpace& space = open_ground();
  const auto plan =
      wend::make_planner("astar", space).value()->plan(wend::Query::between({1, 1}, {8, 5}));
  ASSERT_TRUE(plan);
  double metres = 0;
  const wend::Route route(plan->path, space.map().frame());
  for (const wend::RouteLeg& leg : route.legs()) metres += leg.line.length();
  EXPECT_EQ(metres, route.length());

  const wend::Path& path = plan->path;
  const wend::Frame& frame = space.map().frame();
  const auto controller = wend::make_controller("pure_pursuit").value();
  const wend::MapPose pose = route.start();
  WheeledRobot robot;
  wend::Follower follower(*controller);  // the controller outlives it
  follower.follow(wend::Route(path, frame));
  const wend::FollowerStep step = follower.step(pose, 0.05);
  if (step.state == wend::FollowerState::driving) robot.go(step.command);
  EXPECT_GT(robot.told.linear, 0);
}

TEST(Snippets, OfGivenRoute) {
  const auto controller = wend::make_controller("pure_pursuit").value();
  wend::Follower follower(*controller);
  const auto followed = [&](const std::vector<wend::MapPose>& poses) {
    const auto route = wend::given_route(poses);  // metres, in the frame of the robot's poses
    if (!route) return report(route.error().message);
    follower.follow(*route);
  };
  followed({{2, 0, 0}, {1, 0, 0}});
  EXPECT_LT(follower.step({2, 0, 0}, 0.05).command.linear, 0) << "in reverse";
}

TEST(Snippets, OfPlaceToJoin) {
  const wend::Route route(wend::Path::along({{0, 0}, {9, 0}}), {});
  const wend::MapPose pose{4, 0.1, 0};
  double metres_behind = 0;
  const auto place = wend::place_to_join(route, pose, {.within = 1, .tie = 0.15});
  if (place) metres_behind = place->along;  // of the leg place->leg
  EXPECT_EQ(metres_behind, 4);
}

TEST(Snippets, OfRemainingAndSimulation) {
  const wend::FreeSpace& space = open_ground();
  const auto plan =
      wend::make_planner("astar", space).value()->plan(wend::Query::between({1, 1}, {8, 5}));
  ASSERT_TRUE(plan);
  const wend::Path& path = plan->path;
  const wend::Pose pose{3, 2, 0};
  double driven_so_far = 0;
  const wend::Remaining rest = wend::remaining(path, pose, driven_so_far);
  driven_so_far = rest.along;
  EXPECT_NEAR(rest.path.length(), path.length() - driven_so_far, 1e-9);

  reported = "";
  auto controller = wend::make_controller("pid");
  const wend::Drive drive = wend::simulate(space, plan->path, **controller, {}, {.seed = 7});
  if (drive.outcome != wend::DriveOutcome::reached) report(wend::describe(drive.outcome));
  EXPECT_EQ(reported, "");
}

}  // namespace
