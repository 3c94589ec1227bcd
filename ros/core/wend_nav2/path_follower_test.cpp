// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_follower.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/planner/planners.hpp"
#include "wend_nav2/costmaps_test.hpp"
#include "wend_nav2/path_planner.hpp"
#include "wend_nav2/simulated_robot_test.hpp"

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
  RobotShape shape = kDisc;
  double fastest = 0;
  double slowest = 0;
  double most_turned = 0;  // from where it began
  double first_heading = 0;
  int periods = 0;
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
        follower.command({on_path(), robot.state.pose, robot.state.velocity, shape, kPeriod});
    const wend::Velocity velocity = told.value_or(wend::Velocity{});
    fastest = std::max(fastest, velocity.linear);
    slowest = std::min(slowest, velocity.linear);
    if (periods++ == 0) first_heading = robot.state.pose.heading;
    collided = !robot.hold(map, velocity, kPeriod) || collided;
    const double turned = wend::normalized_angle(robot.state.pose.heading - first_heading);
    most_turned = std::max(most_turned, std::abs(turned));
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

TEST(PathFollower, RefusesPathsWithWhatIsNotFiniteAndNamesThePlace) {
  Driver driver;
  for (const double number : {std::nan(""), double{INFINITY}, -double{INFINITY}, 1e300, 1e9}) {
    for (const std::size_t at : {0U, 30U, 80U}) {
      Poses path = along({{1, 1}, {5, 1}});
      path[at].y = number;
      const auto taken = driver.follower.set_path(path);
      ASSERT_FALSE(taken) << number;
      EXPECT_EQ(taken.error().kind, ControlFailureKind::invalid_path);
      EXPECT_THAT(taken.error().message, HasSubstr("pose " + std::to_string(at) + " of the path"));
    }
  }
}

TEST(PathFollower, WhatIsMeasuredAndNotFiniteIsNeverAnswered) {
  for (const std::string& name : wend::controllers().names()) {
    SCOPED_TRACE(name);
    Driver driver({}, name);
    driver.follower.costmap().read(driver.map.layout, driver.map.costs);
    const ControlMoment good{{1, 1, 0}, {1, 1, 0}, {}, kDisc, kPeriod};
    for (const double number : {std::nan(""), double{INFINITY}, -double{INFINITY}, 1e300}) {
      std::vector<ControlMoment> moments(8, good);
      moments[0].on_path.x = moments[1].on_path.heading = number;
      moments[2].in_costmap.y = moments[3].in_costmap.heading = number;
      moments[4].velocity.linear = moments[5].velocity.angular = number;
      moments[6].seconds = number;
      moments[7].robot.footprint = wend::Footprint::disc(number);
      for (const ControlMoment& moment : moments) {
        driver.follower.reset();
        ASSERT_TRUE(driver.follower.set_path(along({{1, 1}, {5, 1}})));
        const auto told = driver.follower.command(moment);
        EXPECT_TRUE(!told || (std::isfinite(told->linear) && std::isfinite(told->angular)));
        const auto after = driver.follower.command(good);
        ASSERT_TRUE(after) << after.error().message;
        EXPECT_TRUE(std::isfinite(after->linear) && std::isfinite(after->angular));
      }
    }
    ControlMoment never = good;
    never.seconds = 0;
    EXPECT_FALSE(driver.follower.command(never));
  }
}

TEST(PathFollower, SpeedLimitsThatAreNoneChangeNothing) {
  Driver driver;
  EXPECT_TRUE(driver.follower.set_speed_limit(0.2));
  for (const double number : {std::nan(""), double{INFINITY}, -double{INFINITY}, -1.0}) {
    EXPECT_FALSE(driver.follower.set_speed_limit(number));
    EXPECT_FALSE(driver.follower.set_speed_limit_percent(number));
    driver.follower.set_goal_tolerance(number, number);
  }
  const Poses path = along({{1, 1}, {3, 1}});
  driver.robot.state.pose = path.front();
  ASSERT_TRUE(driver.follower.set_path(path));
  EXPECT_FALSE(driver.drive_to(path.back()));
  EXPECT_NEAR(driver.fastest, 0.2, 1e-9);
  EXPECT_TRUE(driver.follower.set_speed_limit(1e300));
}

TEST(PathFollower, StandsIfThePoseIsOld) {
  Driver driver(wend::OptionValues{{"pose_timeout", "0.5"}});
  driver.robot.state.pose = {1, 1, 0};
  ASSERT_TRUE(driver.follower.set_path(along({{1, 1}, {5, 1}})));
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(driver.step());
  ControlMoment moment{{2, 1, 0}, {2, 1, 0}, {0.5, 0}, kDisc, kPeriod, 0.5};
  EXPECT_TRUE(driver.follower.command(moment));
  for (const double age : {0.6, 9.0, std::nan("")}) {
    moment.age = age;
    const auto told = driver.follower.command(moment);
    ASSERT_FALSE(told) << age;
    EXPECT_EQ(told.error().kind, ControlFailureKind::old_pose);
    EXPECT_THAT(told.error().message, HasSubstr("pose_timeout"));
  }
  moment.age = 0;
  const auto on = driver.follower.command(moment);
  ASSERT_TRUE(on) << "and goes on";
  EXPECT_LT(on->linear, 0.1) << "from standing";
  EXPECT_EQ(control_settings_from("p", {})->plugin.pose_timeout, 1);
}

/// Straight back from (5, 1) to (2, 1), whatever that is in the path's frame.
TEST(PathFollower, AStraightPathInReverseIsDrivenInReverseAtHeadingZeroToo) {
  for (const std::string& name : wend::controllers().names()) {
    for (const std::string drivetrain : {"differential", "bicycle"}) {
      const wend::ControllerInfo& info = *wend::controllers().find(name);
      if (drivetrain == "bicycle" && info.turns_in_place) continue;
      for (const double heading : {0.0, 1e-9, 0.05, wend::kPi}) {
        SCOPED_TRACE(name + ' ' + drivetrain + ' ' + std::to_string(heading));
        Driver driver({{"drivetrain", drivetrain}}, name);
        Poses path;
        for (int i = 0; i <= 60; ++i) {
          path.push_back({3 + 1.5 * std::cos(heading) - 0.05 * i * std::cos(heading),
                          3 - 0.05 * i * std::sin(heading), heading});
        }
        driver.robot.state.pose = path.front();
        ASSERT_TRUE(driver.follower.set_path(path));
        const auto failure = driver.drive_to(path.back());
        EXPECT_FALSE(failure) << failure->message;
        EXPECT_LT(driver.slowest, -0.2);
        EXPECT_LT(driver.fastest, 0.05);
        EXPECT_LT(driver.most_turned, 0.3);
      }
    }
  }
}

TEST(PathFollower, APathThatEndsWithATurnIsNotAtItsEndBeforeTheTurn) {
  for (const std::string& name : wend::controllers().names()) {
    SCOPED_TRACE(name);
    Driver driver({}, name);
    Poses path = along({{1, 1}, {3, 1}});
    for (const double heading : {0.8, 1.6, 2.4, 3.0}) path.push_back({3, 1, heading});
    driver.robot.state.pose = path.front();
    ASSERT_TRUE(driver.follower.set_path(path));
    const auto failure = driver.drive_to(path.back());
    EXPECT_FALSE(failure) << failure->message;
    EXPECT_NEAR(driver.robot.state.pose.heading, 3, kTolerance);
  }
}

TEST(PathFollower, APathOfOnePlaceIsDrivenAtNormalSpeed) {
  for (const std::string& name : wend::controllers().names()) {
    for (const std::size_t count : {1U, 2U}) {
      SCOPED_TRACE(name);
      Driver driver({}, name);
      driver.robot.state.pose = {1, 1, 0};
      const Poses path(count, wend::MapPose{1.7, 1.2, 1});
      ASSERT_TRUE(driver.follower.set_path(path));
      const auto failure = driver.drive_to(path.back());
      EXPECT_FALSE(failure) << failure->message;
      EXPECT_LT(driver.periods * kPeriod, 6) << "RPP takes 1 to 2 s to 0.6 m";
    }
  }
  Driver driver;
  driver.robot.state.pose = {1, 1, 0};
  ASSERT_TRUE(driver.follower.set_path({{3, 3, 0}}));
  const auto told = driver.step();
  ASSERT_FALSE(told);
  EXPECT_THAT(told.error().message, HasSubstr("farther than 1 m"));
}

TEST(PathFollower, TheSamePathAgainChangesNothing) {
  for (const std::string& name : wend::controllers().names()) {
    SCOPED_TRACE(name);
    const Poses path = along({{1, 1}, {3, 1}, {3, 4}});
    Driver once({}, name);
    Driver again({}, name);
    for (Driver* driver : {&once, &again}) {
      driver->robot.state.pose = path.front();
      ASSERT_TRUE(driver->follower.set_path(path));
    }
    for (int i = 0; i < 400; ++i) {
      if (i % 20 == 10) {
        again.follower.set_goal_tolerance(kTolerance, kTolerance);
        ASSERT_TRUE(again.follower.set_path(path));
      }
      const auto told = once.step();
      const auto told_again = again.step();
      ASSERT_TRUE(told && told_again);
      ASSERT_EQ(*told, *told_again) << i;
    }
    EXPECT_LT(distance(again.robot.state.pose.point(), path.back().point()), kTolerance);
  }
}

TEST(PathFollower, JoinsAPathInItsMiddleAndDrivesOn) {
  const Poses path = along({{1, 1}, {5, 1}, {5, 3}, {1, 3}, {1, 5}, {5, 5}});
  for (const std::string& name : wend::controllers().names()) {
    for (std::size_t at = 20; at < path.size() - 20; at += 55) {
      SCOPED_TRACE(name + " at pose " + std::to_string(at));
      Driver driver({}, name);
      driver.robot.state.pose = path[at];
      driver.robot.state.pose.y += 0.1;
      ASSERT_TRUE(driver.follower.set_path(path));
      const auto failure = driver.drive_to(path.back());
      EXPECT_FALSE(failure) << failure->message;
      const double left = static_cast<double>(path.size() - at) * 0.05;
      EXPECT_LT(driver.periods * kPeriod, left / 0.2 + 12) << "nothing is driven twice";
    }
  }
}

TEST(PathFollower, GoesOnAfterACancelledDrive) {
  const Poses path = along({{1, 1}, {5.5, 1}});
  Driver driver;
  driver.robot.state.pose = path.front();
  ASSERT_TRUE(driver.follower.set_path(path));
  while (driver.robot.state.pose.x < 4.2) ASSERT_TRUE(driver.step());
  while (!driver.follower.stop()) ASSERT_TRUE(driver.step());
  driver.follower.reset();
  ASSERT_TRUE(driver.follower.set_path(path));
  const auto failure = driver.drive_to(path.back());
  EXPECT_FALSE(failure) << failure->message;
}

TEST(PathFollower, JoinsAPathOnItsOwnSideOfAWall) {
  // The path comes back behind a wall, nearer to the robot than its beginning.
  Driver driver;
  for (int x = 5; x < 50; ++x) driver.map.at(x, 15) = 254;
  const Poses path = along({{1, 1}, {5.4, 1}, {5.4, 1.72}, {1, 1.72}});
  driver.robot.state.pose = {3, 1.38, 0};
  ASSERT_TRUE(driver.follower.set_path(path));
  const auto failure = driver.drive_to({1, 1.72, wend::kPi});
  EXPECT_FALSE(failure) << failure->message;
  EXPECT_FALSE(driver.collided);
}

TEST(PathFollower, ARobotThatDoesNotGetOnIsStuckHoweverOftenItGetsPathsToItsGoal) {
  for (const bool moved : {false, true}) {
    Driver driver(wend::OptionValues{{"stuck_time", "2"}});
    driver.follower.costmap().read(driver.map.layout, driver.map.costs);
    std::optional<ControlFailure> failure;
    int periods = 0;
    for (; periods < 100 && !failure; ++periods) {
      // Each half second a path from where the robot is, or a little beside it.
      if (periods % 10 == 0) {
        const double begin = moved ? 1 + 0.001 * periods : 1;
        ASSERT_TRUE(driver.follower.set_path(along({{begin, 1}, {5, 1}})));
      }
      const auto told = driver.follower.command({{1, 1, 0}, {1, 1, 0}, {}, kDisc, kPeriod});
      if (!told) failure = told.error();
    }
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->kind, ControlFailureKind::no_progress);
    EXPECT_NEAR(periods * kPeriod, 2, 0.3);
  }
}

/// A wall in the world, and a costmap that is turned and moved against it, as one in an odometry frame is: a cell is
/// lethal if its middle is in the wall, as a rolling static layer has it, and 253 within `inscribed` of one that is.
struct TurnedWall {
  wend::MapPose costmap;  // its origin in the world
  double begin = 3;       // the wall is at x from here on
  Costmap map = empty_costmap(100, 100, 0.05);

  wend::MapPoint in_world(wend::MapPoint at) const {
    const double c = std::cos(costmap.heading);
    const double s = std::sin(costmap.heading);
    return {costmap.x + c * at.x - s * at.y, costmap.y + s * at.x + c * at.y};
  }

  void draw(double inscribed) {
    std::vector<wend::MapPoint> lethal;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const wend::MapPoint middle = middle_of(map, x, y).point();
        const double at = in_world(middle).x;
        if (at >= begin && at <= begin + 0.3) lethal.push_back(middle);
      }
    }
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const wend::MapPoint middle = middle_of(map, x, y).point();
        double gap = 9;
        for (const wend::MapPoint& other : lethal) gap = std::min(gap, distance(middle, other));
        map.at(x, y) = gap == 0 ? 254 : gap <= inscribed ? 253 : 0;
      }
    }
  }
};

RC_GTEST_PROP(PathFollower, NeverStopsInTheEdgeOfAnObstacleOfATurnedCostmap, ()) {
  const double turn = *rc::gen::inRange(-314, 314) / 100.0;
  const double radius = *rc::gen::inRange(15, 26) / 100.0;
  const double course = *rc::gen::inRange(-60, 61) / 100.0;
  // The costmap's middle is near (2, 0) of the world.
  const wend::MapPoint middle{2 + *rc::gen::inRange(0, 50) / 1000.0,
                              *rc::gen::inRange(0, 50) / 1000.0};
  TurnedWall wall{{middle.x - 2.5 * std::cos(turn) + 2.5 * std::sin(turn),
                   middle.y - 2.5 * std::sin(turn) - 2.5 * std::cos(turn), turn}};
  wall.draw(radius);
  const RobotShape shape{wend::Footprint::disc(radius), true};
  PathFollower follower;
  const auto name = *rc::gen::elementOf(wend::controllers().names());
  follower.set(*control_settings_from(name, {}));
  follower.costmap().read(wall.map.layout, wall.map.costs);
  wend::MapPose at{1.5, -std::tan(course), course};  // in the world
  const wend::MapPoint end{4.5, 2 * std::tan(course)};
  RC_ASSERT(follower.set_path(along({at.point(), end})).has_value());
  bool blocked = false;
  for (int i = 0; i < 400 && !blocked; ++i) {
    const double c = std::cos(-turn);
    const double s = std::sin(-turn);
    const double x = at.x - wall.costmap.x;
    const double y = at.y - wall.costmap.y;
    const wend::MapPose in_costmap{c * x - s * y, s * x + c * y,
                                   wend::normalized_angle(at.heading - turn)};
    const auto told = follower.command({at, in_costmap, {}, shape, kPeriod});
    blocked = !told;
    if (told) at = wend::hold(at, *told, kPeriod).to.pose;
    RC_ASSERT(at.x + radius <= wall.begin + 1e-9);
  }
  RC_ASSERT(blocked);
  RC_ASSERT(at.x + radius > wall.begin - 0.2);
}

TEST(PathFollower, DrivesThroughAPassageThatTheRobotJustFitsIn) {
  // Walls at 1.9 and 2.3 m leave 0.4 m, cells of 0.1 m, and the robot has 0.38 m.
  Driver driver;
  for (int x = 20; x < 40; ++x) driver.map.at(x, 18) = driver.map.at(x, 23) = 254;
  const RobotShape shape{wend::Footprint::disc(0.19), true};
  driver.robot.radius = 0.19;
  driver.shape = shape;
  const Poses path = along({{1, 2.1}, {5, 2.1}});
  driver.robot.state.pose = path.front();
  ASSERT_TRUE(driver.follower.set_path(path));
  const auto failure = driver.drive_to(path.back());
  EXPECT_FALSE(failure) << failure->message;
  EXPECT_FALSE(driver.collided);
}

/// Costs as an inflation layer of Nav2 makes them of lethal cells.
Costmap inflated(const Costmap& bare, double inscribed, double inflation) {
  Costmap map = bare;
  for (int y = 0; y < map.layout.height; ++y) {
    for (int x = 0; x < map.layout.width; ++x) {
      double gap = 99;
      for (int b = 0; b < map.layout.height; ++b) {
        for (int a = 0; a < map.layout.width; ++a) {
          if (bare.at(a, b) == 254) gap = std::min(gap, std::hypot(a - x, b - y));
        }
      }
      gap *= map.layout.resolution;
      if (gap > inflation || bare.at(x, y) == 254) continue;
      const double cost = gap <= inscribed ? 253 : 252 * std::exp(-3 * (gap - inscribed));
      map.at(x, y) = static_cast<std::uint8_t>(cost);
    }
  }
  return map;
}

TEST(PathFollower, DrivesThePathsOfPlannersInAnInflatedCostmap) {
  // The corners of these walls are where paths come nearest to obstacles.
  Costmap bare = empty_costmap(100, 60, 0.05);
  for (int y = 0; y < 40; ++y) bare.at(30, y) = 254;
  for (int y = 20; y < 60; ++y) bare.at(60, y) = 254;
  for (int i = 0; i < 12; ++i) bare.at(72 + i, 12 + i) = bare.at(73 + i, 12 + i) = 254;
  const Costmap map = inflated(bare, 0.2, 0.55);
  const RobotShape shape{wend::Footprint::disc(0.2), true};
  for (const std::string name : {"astar", "jps", "any_angle", "theta_star", "hybrid_astar"}) {
    PathPlanner planner;
    planner.set(*settings_from(name, {}));
    planner.costmap().read(map.layout, map.costs);
    const auto path = planner.plan({{0.5, 0.5, 1}, {4.6, 0.9, 0}, shape}, {});
    ASSERT_TRUE(path) << path.error().message;
    // Paths of planners that count no costs touch obstacles, and pure pursuit cuts corners.
    const bool counts_costs = wend::planners().find(name)->capabilities.terrain;
    for (const std::string controller : {"pure_pursuit", "stanley", "pid"}) {
      if (controller == "pure_pursuit" && !counts_costs) continue;
      SCOPED_TRACE(name + " and " + controller);
      Driver driver({}, controller);
      driver.map = map;
      driver.shape = shape;
      driver.robot.radius = 0.2;
      driver.robot.state.pose = path->front();
      ASSERT_TRUE(driver.follower.set_path(*path));
      const auto failure = driver.drive_to(path->back());
      EXPECT_FALSE(failure) << failure->message;
      EXPECT_FALSE(driver.collided);
    }
  }
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
