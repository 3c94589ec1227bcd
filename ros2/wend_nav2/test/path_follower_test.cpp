// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_follower.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "costmaps.hpp"
#include "simulated_robot.hpp"
#include "wend/geometry/angle.hpp"
#include "wend_nav2/path_planner.hpp"

namespace wend_nav2 {
namespace {

using Poses = std::vector<wend::MapPose>;
using test::Costmap;
using test::empty_costmap;
using test::middle_of;
using test::SimulatedRobot;
using testing::HasSubstr;

constexpr double kPeriod = 0.05;  // s
constexpr double kRadius = 0.1;   // m
constexpr double kTolerance = 0.2;
const RobotShape kDisc{wend::Footprint::disc(kRadius), false};

/// A robot, its follower and their costmap. The path's frame may be another one than the costmap's: `odometry` is
/// where the costmap's origin is in it.
struct Driver {
  Costmap map = empty_costmap(60, 60);
  SimulatedRobot robot = {};
  PathFollower follower = {};
  wend::MapPose odometry = {};
  double fastest = 0;
  double slowest = 0;
  bool collided = false;

  explicit Driver(const wend::OptionValues& values = {},
                  const std::string& controller = "pure_pursuit") {
    const auto settings = control_settings_from(controller, values);
    EXPECT_TRUE(settings) << settings.error().message;
    robot.model = settings->robot;
    follower.set(*settings);
    follower.set_goal_tolerance(kTolerance, kTolerance);
  }

  wend::MapPose on_path() const {
    const wend::MapPose& pose = robot.state.pose;
    const double c = std::cos(odometry.heading);
    const double s = std::sin(odometry.heading);
    return {odometry.x + c * pose.x - s * pose.y, odometry.y + s * pose.x + c * pose.y,
            wend::normalized_angle(odometry.heading + pose.heading)};
  }

  /// One period of following.
  wend::Expected<wend::Velocity, ControlFailure> step() {
    follower.costmap().read(map.layout, map.costs);
    const auto told =
        follower.command({on_path(), robot.state.pose, robot.state.velocity, kDisc, kPeriod});
    const wend::Velocity velocity = told.value_or(wend::Velocity{});
    fastest = std::max(fastest, velocity.linear);
    slowest = std::min(slowest, velocity.linear);
    collided = !robot.hold(map, velocity, kPeriod) || collided;
    return told;
  }

  /// Until the robot stands within the tolerance of the pose, or the first failure. Nothing: it stands.
  std::optional<ControlFailure> drive_to(const wend::MapPose& goal) {
    for (int i = 0; i < 4000; ++i) {
      const auto told = step();
      if (!told) return told.error();
      const wend::MapPose at = on_path();
      if (*told == wend::Velocity{} && distance(at.point(), goal.point()) < kTolerance &&
          std::abs(wend::normalized_angle(at.heading - goal.heading)) < kTolerance) {
        return std::nullopt;
      }
    }
    return ControlFailure{ControlFailureKind::other, "it takes for ever"};
  }
};

/// Poses from one point to the next, 5 cm apart, that face along the way, or away from it.
Poses along(const std::vector<wend::MapPoint>& points, bool reverse = false) {
  Poses poses;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = distance(points[i - 1], points[i]);
    const double way = std::atan2(points[i].y - points[i - 1].y, points[i].x - points[i - 1].x);
    const int count = static_cast<int>(std::ceil(length / 0.05));
    for (int n = 0; n <= count; ++n) {
      const double share = static_cast<double>(n) / count;
      poses.push_back({points[i - 1].x + share * (points[i].x - points[i - 1].x),
                       points[i - 1].y + share * (points[i].y - points[i - 1].y),
                       reverse ? wend::normalized_angle(way + wend::kPi) : way});
    }
  }
  return poses;
}

TEST(PathFollower, ArrivesWithEveryControllerAheadAndInReverse) {
  for (const std::string& name : wend::controllers().names()) {
    for (const bool reverse : {false, true}) {
      SCOPED_TRACE(name + (reverse ? " in reverse" : ""));
      Driver driver({}, name);
      const Poses path = along({{1, 1}, {3, 1}, {5, 2}}, reverse);
      driver.robot.state.pose = path.front();
      ASSERT_TRUE(driver.follower.set_path(path));
      const auto failure = driver.drive_to(path.back());
      EXPECT_FALSE(failure) << failure->message;
      EXPECT_FALSE(driver.collided);
      if (reverse) {
        EXPECT_LT(driver.slowest, -0.2);
      } else {
        EXPECT_GT(driver.fastest, 0.2);
      }
    }
  }
}

TEST(PathFollower, DrivesACarsPathWithItsReversals) {
  Driver driver(wend::OptionValues{
      {"drivetrain", "bicycle"}, {"wheelbase", "0.3"}, {"steering_limit", "0.7"}});
  PathPlanner planner;
  planner.set(*settings_from("hybrid_astar", {{"turning_radius", "0.5"}, {"spacing", "0.02"}}));
  planner.costmap().read(driver.map.layout, driver.map.costs);
  const auto path = planner.plan({{2, 3, 0}, {2.2, 3.5, wend::kPi}, kDisc}, {});
  ASSERT_TRUE(path);
  driver.robot.state.pose = path->front();
  ASSERT_TRUE(driver.follower.set_path(*path));
  const auto failure = driver.drive_to(path->back());
  EXPECT_FALSE(failure) << failure->message << " heading " << driver.robot.state.pose.heading;
  EXPECT_LT(driver.slowest, -0.1);
  EXPECT_GT(driver.fastest, 0.1);
}

RC_GTEST_PROP(PathFollower, NeverCollidesAndSaysWhyItDoesNotArrive, ()) {
  Driver driver;
  const int walls = *rc::gen::inRange(0, 60);
  for (int i = 0; i < walls; ++i) {
    const int x = *rc::gen::inRange(0, 60);
    const int y = *rc::gen::inRange(0, 60);
    driver.map.at(x, y) = 254;
  }
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) driver.map.at(x, y) = 0;
  }
  PathPlanner planner;
  planner.set(*settings_from("astar", {}));
  planner.costmap().read(driver.map.layout, driver.map.costs);
  const auto path = planner.plan({{0.25, 0.25, 0}, {5.5, 5.5, 1}, kDisc}, {});
  if (!path) return;
  // What the planner did not know.
  const int boxes = *rc::gen::inRange(0, 4);
  for (int i = 0; i < boxes; ++i) {
    const int x = *rc::gen::inRange(6, 60);
    const int y = *rc::gen::inRange(6, 60);
    driver.map.at(x, y) = 254;
  }
  driver.robot.state.pose = {0.25, 0.25, 0.5};
  RC_ASSERT(driver.follower.set_path(*path).has_value());
  const auto failure = driver.drive_to(path->back());
  RC_ASSERT(!driver.collided);
  if (failure) {
    RC_ASSERT(failure->kind == ControlFailureKind::no_valid_control ||
              failure->kind == ControlFailureKind::no_progress ||
              failure->kind == ControlFailureKind::invalid_path);
    RC_ASSERT(!failure->message.empty());
  }
}

TEST(PathFollower, StopsBeforeWhatComesIntoTheWayAndDrivesOnWhenItHasGone) {
  Driver driver;
  const Poses path = along({{1, 1}, {5, 1}});
  driver.robot.state.pose = path.front();
  ASSERT_TRUE(driver.follower.set_path(path));
  while (driver.robot.state.pose.x < 2) ASSERT_TRUE(driver.step());
  for (int y = 0; y < 20; ++y) driver.map.at(35, y) = 254;
  const auto failure = driver.drive_to(path.back());
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, ControlFailureKind::no_valid_control);
  EXPECT_THAT(failure->message, HasSubstr("cannot drive on without a collision"));
  EXPECT_FALSE(driver.collided);
  EXPECT_GT(driver.robot.state.pose.x, 3.2);
  for (int y = 0; y < 20; ++y) driver.map.at(35, y) = 0;
  EXPECT_FALSE(driver.drive_to(path.back()));
}

TEST(PathFollower, FollowsAPathOfAnotherFrameThanTheCostmaps) {
  Driver driver;
  driver.odometry = {20, -7, 2};
  driver.robot.state.pose = {1, 1, 0};
  const wend::MapPose start = driver.on_path();
  const wend::MapPoint end{start.x + 3 * std::cos(start.heading),
                           start.y + 3 * std::sin(start.heading)};
  ASSERT_TRUE(driver.follower.set_path(along({start.point(), end})));
  EXPECT_FALSE(driver.drive_to({end.x, end.y, start.heading}));
  EXPECT_NEAR(driver.robot.state.pose.x, 4, kTolerance);
  EXPECT_NEAR(driver.robot.state.pose.y, 1, kTolerance);
}

TEST(PathFollower, ChangesItsVelocityNoFasterThanItsLimitsAllow) {
  Driver driver(wend::OptionValues{{"acceleration", "0.4"}, {"turn_acceleration", "2"}});
  driver.robot.state.pose = {1, 1, 0};
  wend::Velocity before;
  const std::vector<Poses> paths{along({{1, 1}, {5, 1}}), along({{1, 1}, {3, 2}, {5, 5}}),
                                 along({{1, 1}, {2, 1}, {2, 4}})};
  for (int i = 0; i < 300; ++i) {
    // A new path each second, from where the robot is.
    if (i % 20 == 0) {
      Poses path = paths[static_cast<std::size_t>(i / 20) % paths.size()];
      ASSERT_TRUE(driver.follower.set_path(path));
    }
    const auto told = driver.step();
    if (!told) break;
    ASSERT_LE(std::abs(told->linear - before.linear), 0.4 * kPeriod + 1e-9);
    ASSERT_LE(std::abs(told->angular - before.angular), 2 * kPeriod + 1e-9);
    before = *told;
  }
  EXPECT_GT(driver.fastest, 0.3);
}

TEST(PathFollower, BeginsFromTheVelocityThatTheRobotHas) {
  Driver driver(wend::OptionValues{{"acceleration", "0.4"}});
  driver.robot.state = {{1, 1, 0}, {0.3, 0}};
  ASSERT_TRUE(driver.follower.set_path(along({{1, 1}, {5, 1}})));
  const auto told = driver.step();
  ASSERT_TRUE(told);
  EXPECT_NEAR(told->linear, 0.32, 1e-9);
}

TEST(PathFollower, KeepsToSpeedLimitsInMetresAndInPercent) {
  const auto fastest_with = [](auto&& limit) {
    Driver driver;
    const Poses path = along({{1, 1}, {5, 1}});
    driver.robot.state.pose = path.front();
    EXPECT_TRUE(driver.follower.set_path(path));
    while (driver.robot.state.pose.x < 1.5) EXPECT_TRUE(driver.step());
    limit(driver.follower);
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(driver.step());
    driver.fastest = 0;
    EXPECT_FALSE(driver.drive_to(path.back()));
    return driver.fastest;
  };
  EXPECT_NEAR(fastest_with([](PathFollower& follower) { follower.set_speed_limit(0.2); }), 0.2,
              1e-9);
  EXPECT_NEAR(fastest_with([](PathFollower& follower) { follower.set_speed_limit_percent(30); }),
              0.15, 1e-9);
  EXPECT_NEAR(fastest_with([](PathFollower& follower) {
                follower.set_speed_limit_percent(30);
                follower.set_speed_limit(0);
              }),
              0.5, 1e-9);
  EXPECT_NEAR(fastest_with([](PathFollower& follower) { follower.set_speed_limit(7); }), 0.5, 1e-9);
}

TEST(PathFollower, BrakesWhenItIsStopped) {
  Driver driver(wend::OptionValues{{"acceleration", "0.4"}});
  driver.robot.state.pose = {1, 1, 0};
  ASSERT_TRUE(driver.follower.set_path(along({{1, 1}, {5, 1}})));
  while (driver.robot.state.pose.x < 2) ASSERT_TRUE(driver.step());
  const double speed = driver.robot.state.velocity.linear;
  int steps = 0;
  for (; !driver.follower.stop(); ++steps) ASSERT_TRUE(driver.step());
  EXPECT_EQ(driver.robot.state.velocity, wend::Velocity{});
  EXPECT_NEAR(steps * 0.4 * kPeriod, speed, 0.4 * kPeriod + 1e-9);
}

TEST(PathFollower, FailuresSayWhatIsWrong) {
  Driver driver(wend::OptionValues{{"off_path", "0.5"}, {"stuck_time", "1"}});
  driver.robot.state.pose = {1, 1, 0};
  const auto failure_now = [&] {
    const auto told = driver.step();
    EXPECT_FALSE(told);
    return told ? ControlFailure{} : told.error();
  };
  EXPECT_EQ(failure_now().kind, ControlFailureKind::invalid_path);
  EXPECT_EQ(driver.follower.set_path({}).error().kind, ControlFailureKind::invalid_path);
  EXPECT_EQ(failure_now().kind, ControlFailureKind::invalid_path);
  EXPECT_EQ(driver.follower.set_path({{std::nan(""), 0, 0}}).error().kind,
            ControlFailureKind::invalid_path);
  ASSERT_TRUE(driver.follower.set_path(along({{1, 3}, {5, 3}})));
  const ControlFailure lost = failure_now();
  EXPECT_EQ(lost.kind, ControlFailureKind::invalid_path);
  EXPECT_THAT(lost.message, HasSubstr("farther than 0.5 m"));
  driver.follower.reset();
  driver.map.at(10, 9) = driver.map.at(10, 10) = 254;
  driver.robot.state.pose = {0.95, 1, 0};
  ASSERT_TRUE(driver.follower.set_path(along({{0.95, 1}, {5, 1}})));  // deeper into it
  const ControlFailure inside = failure_now();
  EXPECT_EQ(inside.kind, ControlFailureKind::no_valid_control);
  EXPECT_THAT(inside.message, HasSubstr("is in an obstacle"));
}

/// How deep the robot's disc is in lethal cells, in metres, over all cells.
double depth_of(const Costmap& map, const wend::MapPose& pose) {
  const double size = map.layout.resolution;
  double least = HUGE_VAL;
  for (int y = 0; y < map.layout.height; ++y) {
    for (int x = 0; x < map.layout.width; ++x) {
      if (map.at(x, y) != 254) continue;
      const double dx = std::max({x * size - pose.x, pose.x - (x + 1) * size, 0.0});
      const double dy = std::max({y * size - pose.y, pose.y - (y + 1) * size, 0.0});
      least = std::min(least, std::hypot(dx, dy));
    }
  }
  return std::max(0.0, kRadius - least);
}

TEST(PathFollower, LeavesAnObstacleThatItTouchesAndNeverGoesDeeper) {
  for (const std::string& name : wend::controllers().names()) {
    for (const double way : {0.0, 0.7, -1.2, 3.14159}) {
      SCOPED_TRACE(name + " towards " + std::to_string(way));
      Driver driver({}, name);
      for (int y = 0; y < 60; ++y) driver.map.at(27, y) = 254;  // up to x = 2.8
      const bool reverse = way > 2;
      driver.robot.state.pose = {2.88, 3, reverse ? 3.14159 : way};
      const double to_x = reverse ? 4.5 : 2.88 + 1.5 * std::cos(way);
      const double to_y = reverse ? 3 : 3 + 1.5 * std::sin(way);
      const Poses path = along({{2.88, 3}, {to_x, to_y}}, reverse);
      ASSERT_TRUE(driver.follower.set_path(path));
      double deepest = depth_of(driver.map, driver.robot.state.pose);
      EXPECT_NEAR(deepest, 0.02, 1e-9);
      std::optional<ControlFailure> failure;
      for (int i = 0; i < 400 && !failure; ++i) {
        const auto told = driver.step();
        if (!told) failure = told.error();
        const double depth = depth_of(driver.map, driver.robot.state.pose);
        EXPECT_LE(depth, deepest + 1e-3);
        deepest = std::min(deepest, depth);
        const wend::MapPose at = driver.on_path();
        if (distance(at.point(), path.back().point()) < kTolerance) break;
      }
      EXPECT_FALSE(failure) << failure->message;
      EXPECT_EQ(deepest, 0);
    }
  }
}

TEST(PathFollower, SaysWhenTheRobotDoesNotMove) {
  Driver driver(wend::OptionValues{{"stuck_time", "1"}});
  ASSERT_TRUE(driver.follower.set_path(along({{1, 1}, {5, 1}})));
  driver.follower.costmap().read(driver.map.layout, driver.map.costs);
  std::optional<ControlFailure> failure;
  for (int i = 0; i < 100 && !failure; ++i) {
    const auto told = driver.follower.command({{1, 1, 0}, {1, 1, 0}, {}, kDisc, kPeriod});
    if (!told) failure = told.error();
  }
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, ControlFailureKind::no_progress);
  EXPECT_THAT(failure->message, HasSubstr("at (1, 1)"));
}

TEST(PathFollower, OutsideTheCostmapThereIsNoCommand) {
  Driver driver;
  driver.robot.state.pose = {7, 1, 0};
  ASSERT_TRUE(driver.follower.set_path(along({{7, 1}, {9, 1}})));
  const auto told = driver.step();
  ASSERT_FALSE(told);
  EXPECT_EQ(told.error().kind, ControlFailureKind::no_valid_control);
}

}  // namespace
}  // namespace wend_nav2
