#include "wend/control/motion_model.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr VelocityLimits kUnlimited{
    .speed = 1e3, .turn_rate = 1e3, .acceleration = 1e6, .turn_acceleration = 1e6};

MotionModel unlimited() { return {.limits = kUnlimited}; }

MotionModel bicycle() {
  return {.drivetrain = Drivetrain::bicycle,
          .wheelbase = 0.5,
          .steering_limit = std::atan(0.25),  // turns with a radius of 2 m
          .limits = kUnlimited};
}

double any(Random& random, double most) { return (2 * random.uniform() - 1) * most; }

MapPose any_pose(Random& random) { return {any(random, 9), any(random, 9), any(random, kPi)}; }

void expect_near(const MapPose& a, const MapPose& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(normalized_angle(a.heading - b.heading), 0, tolerance);
}

TEST(MotionModel, DrivesALine) {
  const Step step = drive(unlimited(), {{1, 2, kPi / 2}}, {3, 0}, 0.5);
  expect_near(step.to.pose, {1, 3.5, kPi / 2}, 1e-12);
  EXPECT_EQ(step.arc.length, 1.5);
  EXPECT_EQ(step.arc.curvature, 0);
  EXPECT_EQ(step.to.velocity, (Velocity{3, 0}));
}

TEST(MotionModel, DrivesCirclesThatCloseAfterTheirTime) {
  for (const double linear : {2.0, -2.0}) {
    for (const double angular : {0.5, -0.5}) {
      const MapPose start{1, 2, 0.3};
      const double round = 2 * kPi / 0.5;
      expect_near(drive(unlimited(), {start}, {linear, angular}, round).to.pose, start, 1e-12);
      // Half way it is across the circle, whose centre is linear / angular to the left.
      const double across = 2 * linear / angular;
      const MapPose opposite{1 - across * std::sin(0.3), 2 + across * std::cos(0.3), 0.3 + kPi};
      expect_near(drive(unlimited(), {start}, {linear, angular}, round / 2).to.pose, opposite,
                  1e-12);
    }
  }
}

TEST(MotionModel, TurnsInPlace) {
  const Step step = drive(unlimited(), {{1, 2, 3}}, {0, 2}, 0.25);
  EXPECT_EQ(step.to.pose, (MapPose{1, 2, normalized_angle(3.5)}));
  EXPECT_EQ(step.arc.length, 0);
}

TEST(MotionModel, TurnsNearlyInPlaceLikeInPlace) {
  const Step step = drive(unlimited(), {{1, 2, 3}}, {std::numeric_limits<double>::min(), 2}, 0.25);
  expect_near(step.to.pose, {1, 2, 3.5}, 1e-12);
  expect_near(drive(unlimited(), {{1, 2, 3}}, {2e-9, 2}, 0.25).to.pose, {1, 2, 3.5}, 1e-8);
}

/// Midpoint steps, which know nothing of arcs.
MapPose integrated(MapPose pose, const Velocity& velocity, double seconds) {
  constexpr int kSteps = 20000;
  const double step = seconds / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double middle = pose.heading + velocity.angular * step / 2;
    pose = {pose.x + velocity.linear * step * std::cos(middle),
            pose.y + velocity.linear * step * std::sin(middle),
            pose.heading + velocity.angular * step};
  }
  return pose;
}

RC_GTEST_PROP(MotionModel, AgreesWithNumbersAlone, (std::uint64_t seed)) {
  Random random(seed);
  const MapPose start = any_pose(random);
  const Velocity velocity{any(random, 2), any(random, 3)};
  const double seconds = random.uniform() * 3;
  const Step step = drive(unlimited(), {start}, velocity, seconds);
  expect_near(step.to.pose, integrated(start, velocity, seconds), 1e-6);
  expect_near(step.to.pose, end_of(step.arc), 1e-12);
}

RC_GTEST_PROP(MotionModel, DrivesManySmallStepsLikeOne, (std::uint64_t seed)) {
  Random random(seed);
  const Velocity velocity{any(random, 2), any(random, 3)};
  const int steps = random.between(2, 500);
  RobotState robot{any_pose(random), velocity};
  const RobotState once = drive(unlimited(), robot, velocity, 2).to;
  double length = 0;
  for (int i = 0; i < steps; ++i) {
    const Step step = drive(unlimited(), robot, velocity, 2.0 / steps);
    length += step.arc.length;
    robot = step.to;
  }
  expect_near(robot.pose, once.pose, 1e-9);
  EXPECT_NEAR(length, 2 * velocity.linear, 1e-9);
}

TEST(MotionModel, LimitsBeforeItDrives) {
  const MotionModel model{
      .limits = {.speed = 1, .turn_rate = 1, .acceleration = 2, .turn_acceleration = 4}};
  const Step step = drive(model, {{0, 0, 0}, {0.5, 0}}, {5, 5}, 0.125);
  EXPECT_EQ(step.to.velocity, (Velocity{0.75, 0.5}));
  EXPECT_EQ(step.arc.length, 0.75 * 0.125);
}

TEST(Bicycle, TurnsNoTighterThanItsSteeringAllows) {
  EXPECT_NEAR(bicycle().turning_radius(), 2, 1e-12);
  EXPECT_EQ(unlimited().turning_radius(), 0);
  const Step step = drive(bicycle(), {{0, 0, 0}}, {1, 9}, 0.1);
  EXPECT_NEAR(step.arc.curvature, 0.5, 1e-12);
  EXPECT_NEAR(drive(bicycle(), {{0, 0, 0}}, {-1, 9}, 0.1).arc.curvature, -0.5, 1e-12);
  EXPECT_EQ(drive(bicycle(), {{0, 0, 0}}, {1, 0.25}, 0.1).to.velocity.angular, 0.25);
}

TEST(Bicycle, DoesNotTurnWithoutDriving) {
  EXPECT_EQ(drive(bicycle(), {{1, 2, 3}}, {0, 1}, 1).to.pose, (MapPose{1, 2, 3}));
}

RC_GTEST_PROP(Bicycle, KeepsAllLimitsAtOnce, (std::uint64_t seed)) {
  Random random(seed);
  MotionModel model = bicycle();
  model.limits = {.speed = 0.1 + random.uniform(),
                  .turn_rate = 0.1 + random.uniform(),
                  .acceleration = 0.1 + 3 * random.uniform(),
                  .turn_acceleration = 0.1 + 3 * random.uniform()};
  RobotState robot{any_pose(random)};
  constexpr double kRounding = 1e-12;
  for (int i = 0; i < 200; ++i) {
    const double seconds = 0.01 + 0.2 * random.uniform();
    const Velocity before = robot.velocity;
    robot = drive(model, robot, {any(random, 2), any(random, 2)}, seconds).to;
    const Velocity& now = robot.velocity;
    RC_ASSERT(std::abs(now.linear) <= model.limits.speed + kRounding);
    RC_ASSERT(std::abs(now.angular) <= model.limits.turn_rate + kRounding);
    RC_ASSERT(std::abs(now.linear - before.linear) <=
              model.limits.acceleration * seconds + kRounding);
    RC_ASSERT(std::abs(now.angular - before.angular) <=
              model.limits.turn_acceleration * seconds + kRounding);
    RC_ASSERT(std::abs(now.angular) * 2 <= std::abs(now.linear) + kRounding);
  }
}

constexpr VelocityLimits kLimits{
    .speed = 2, .turn_rate = 1, .acceleration = 4, .turn_acceleration = 8};

TEST(Limited, LeavesWhatIsWithinTheLimits) {
  EXPECT_EQ(limited({1, -0.5}, {0.9, -0.2}, kLimits, 0.1), (Velocity{1, -0.5}));
}

TEST(Limited, CutsSpeedAndTurnRate) {
  EXPECT_EQ(limited({9, -9}, {2, -1}, kLimits, 0.1), (Velocity{2, -1}));
  EXPECT_EQ(limited({-9, 9}, {-2, 1}, kLimits, 0.1), (Velocity{-2, 1}));
}

TEST(Limited, ChangesNoFasterThanTheAccelerations) {
  EXPECT_EQ(limited({2, 1}, {0, 0}, kLimits, 0.125), (Velocity{0.5, 1}));
  EXPECT_EQ(limited({0, 0}, {2, 1}, kLimits, 0.0625), (Velocity{1.75, 0.5}));
  EXPECT_EQ(limited({-2, 0}, {2, 0}, kLimits, 0.125), (Velocity{1.5, 0})) << "braking, too";
}

TEST(Limited, BrakesWhatIsTooFastAsHardAsItMay) {
  EXPECT_EQ(limited({5, 0}, {5, 0}, kLimits, 0.125), (Velocity{4.5, 0}));
  EXPECT_EQ(limited({5, 0}, {2.25, 0}, kLimits, 0.125), (Velocity{2, 0}));
}

RC_GTEST_PROP(Limited, IsTheNearestThatIsAllowed, (std::uint64_t seed)) {
  Random random(seed);
  const auto any = [&](double most) { return (2 * random.uniform() - 1) * most; };
  const Velocity now{any(kLimits.speed), any(kLimits.turn_rate)};
  const Velocity wanted{any(5), any(5)};
  const double seconds = random.uniform();
  const Velocity got = limited(wanted, now, kLimits, seconds);
  const auto allowed = [&](double linear, double angular) {
    constexpr double kRounding = 1e-12;
    return std::abs(linear) <= kLimits.speed && std::abs(angular) <= kLimits.turn_rate &&
           std::abs(linear - now.linear) <= kLimits.acceleration * seconds + kRounding &&
           std::abs(angular - now.angular) <= kLimits.turn_acceleration * seconds + kRounding;
  };
  RC_ASSERT(allowed(got.linear, got.angular));
  for (int i = 0; i < 50; ++i) {
    const Velocity other{any(kLimits.speed), any(kLimits.turn_rate)};
    if (!allowed(other.linear, other.angular)) continue;
    RC_ASSERT(std::abs(other.linear - wanted.linear) >=
              std::abs(got.linear - wanted.linear) - 1e-9);
    RC_ASSERT(std::abs(other.angular - wanted.angular) >=
              std::abs(got.angular - wanted.angular) - 1e-9);
  }
}

}  // namespace
}  // namespace wend
