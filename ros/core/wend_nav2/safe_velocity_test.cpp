// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/safe_velocity.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "wend/session/session.hpp"
#include "wend_nav2/costmap_copy.hpp"
#include "wend_nav2/costmaps_test.hpp"
#include "wend_nav2/robot_shape.hpp"
#include "wend_nav2/simulated_robot_test.hpp"

namespace wend_nav2 {
namespace {

using test::Costmap;
using test::costmap_of;
using test::empty_costmap;
using test::SimulatedRobot;

constexpr double kCommandPeriod = 0.05;  // s
constexpr double kRobotRadius = 0.1;     // m

wend::FreeSpace space_of(const Costmap& map,
                         const wend::Footprint& footprint = wend::Footprint::disc(kRobotRadius)) {
  wend::Session session;
  session.set_robot(robot_for(ObstacleRule::footprint, {footprint, true}, true));
  CostmapCopy copy;
  copy.read(map.layout, map.costs);
  EXPECT_TRUE(copy.bring_to(session, scale_for(ObstacleRule::footprint, 0)).has_value());
  return session.view()->space;
}

RC_GTEST_PROP(SafeVelocity, ARobotThatObeysNeverCollides, ()) {
  Costmap map = empty_costmap(30, 30);
  const int walls = *rc::gen::inRange(0, 40);
  for (int i = 0; i < walls; ++i) {
    const int x = *rc::gen::inRange(0, 30);
    const int y = *rc::gen::inRange(0, 30);
    if (std::abs(x - 15) > 2 || std::abs(y - 15) > 2) map.at(x, y) = 254;
  }
  const bool steers = *rc::gen::arbitrary<bool>();
  SimulatedRobot robot{
      .model = {.drivetrain = steers ? wend::Drivetrain::bicycle : wend::Drivetrain::differential,
                .limits = {.speed = 1, .turn_rate = 2, .acceleration = 0.8}},
      .state = {test::middle_of(map, 15, 15, *rc::gen::inRange(-31, 32) / 10.0)},
      .radius = kRobotRadius};
  const wend::FreeSpace space = space_of(map);
  wend::Velocity wanted;
  for (int i = 0; i < 100; ++i) {
    if (i % 10 == 0) {
      const int linear = *rc::gen::inRange(-10, 11);
      const int angular = *rc::gen::inRange(-20, 21);
      wanted = {linear / 10.0, angular / 10.0};
    }
    const auto safe = safe_velocity(robot.model, robot.state, wanted, kCommandPeriod, space);
    RC_ASSERT(safe.has_value());
    RC_ASSERT(std::abs(safe->linear - robot.state.velocity.linear) <= 0.8 * kCommandPeriod + 1e-9);
    RC_ASSERT(robot.hold(map, *safe, kCommandPeriod));
  }
}

TEST(SafeVelocity, IsTheWantedOneWhereThereIsRoom) {
  const Costmap map = empty_costmap(40, 40);
  const wend::RobotState state{test::middle_of(map, 20, 20), {0.4, 0.2}};
  const auto safe = safe_velocity({}, state, {0.42, 0.3}, kCommandPeriod, space_of(map));
  ASSERT_TRUE(safe);
  EXPECT_EQ(*safe, (wend::Velocity{0.42, 0.3}));
}

TEST(SafeVelocity, SlowsDownBeforeAWallAndStopsAtIt) {
  Costmap map = empty_costmap(40, 20);
  for (int y = 0; y < 20; ++y) map.at(30, y) = 254;
  const wend::FreeSpace space = space_of(map);
  SimulatedRobot robot{.state = {test::middle_of(map, 5, 10)}};
  for (int i = 0; i < 200; ++i) {
    const auto safe = safe_velocity(robot.model, robot.state, {0.5, 0}, kCommandPeriod, space);
    ASSERT_TRUE(safe);
    ASSERT_TRUE(robot.hold(map, *safe, kCommandPeriod));
  }
  EXPECT_EQ(robot.state.velocity, wend::Velocity{});
  EXPECT_GT(robot.state.pose.x, 3 - kRobotRadius - 0.05);
}

TEST(SafeVelocity, IsNothingForARobotThatCannotStopInTime) {
  Costmap map = empty_costmap(40, 20);
  for (int y = 0; y < 20; ++y) map.at(30, y) = 254;
  const wend::RobotState state{{2.8, 1, 0}, {0.5, 0}};
  EXPECT_FALSE(safe_velocity({}, state, {0.5, 0}, kCommandPeriod, space_of(map)));
}

TEST(SafeVelocity, DoesNotTurnALongRobotIntoAWall) {
  Costmap map = empty_costmap(40, 40);
  for (int x = 0; x < 40; ++x) map.at(x, 17) = map.at(x, 23) = 254;
  const std::vector<wend::MapPoint> corners{{-0.4, -0.1}, {0.4, -0.1}, {0.4, 0.1}, {-0.4, 0.1}};
  const wend::Footprint box = *footprint_from(corners);
  const wend::FreeSpace space = space_of(map, box);
  SimulatedRobot robot{.state = {test::middle_of(map, 20, 20)}};
  for (int i = 0; i < 100; ++i) {
    const auto safe = safe_velocity(robot.model, robot.state, {0, 1}, kCommandPeriod, space);
    ASSERT_TRUE(safe);
    robot.hold(map, *safe, kCommandPeriod);
    ASSERT_TRUE(space.fits(space.map().frame().to_grid(robot.state.pose)));
  }
  EXPECT_EQ(robot.state.velocity, wend::Velocity{});
  EXPECT_GT(robot.state.pose.heading, 0.1);
}

TEST(SafeVelocity, OfARobotThatHardlyBrakesIsFoundInAFewSteps) {
  const Costmap map = empty_costmap(10, 10);
  const wend::MotionModel model{.limits = {.speed = 1e3, .acceleration = 1e-3}};
  const wend::RobotState state{test::middle_of(map, 5, 5), {1e3, 0}};
  const wend::Path path = stopping_path(model, state, kCommandPeriod, map.layout.frame());
  EXPECT_LT(path.size(), 1000U);
  EXPECT_FALSE(safe_velocity(model, state, {1e3, 0}, kCommandPeriod, space_of(map)));
}

}  // namespace
}  // namespace wend_nav2
