#include "wend/space/se2/steering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "wend/base/random.hpp"

namespace wend {
namespace {

constexpr DriveCosts kCosts{.reverse = 2, .turn = 1.2, .gear_change = 0.7, .spin = 0.5};

double cost_of_motions(const Connection& connection, const Steering& steering, int gear) {
  double cost = 0;
  for (const Motion& motion : connection.all()) {
    cost += steering.cost(motion, std::abs(motion.length));
    if (gear * gear_of(motion) < 0) cost += kCosts.gear_change;
    if (gear_of(motion) != 0) gear = gear_of(motion);
  }
  return cost;
}

class SteeringModels : public ::testing::TestWithParam<DriveKind> {};

TEST_P(SteeringModels, ConnectsToTheGoalAtTheCostThatItSays) {
  const Steering steering(GetParam(), 3, kCosts);
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto pose = [&] {
      return Pose{20 * random.uniform(), 20 * random.uniform(), 2 * kPi * random.uniform() - kPi};
    };
    const Pose from = pose();
    const Pose to = pose();
    const int gear = random.between(-1, 1);
    std::array<Connection, 4> all;
    const int count = steering.connect(from, to, gear, 1e9, all);
    ASSERT_GT(count, 0);
    for (int i = 0; i < count; ++i) {
      const Connection& connection = all[static_cast<std::size_t>(i)];
      Pose end = from;
      for (const Motion& motion : connection.all()) end = pose_after(end, motion);
      EXPECT_LT(straight_distance(end.point(), to.point()), 1e-6);
      EXPECT_LT(std::abs(wrapped_angle(end.heading - to.heading)), 1e-6);
      EXPECT_NEAR(connection.cost, cost_of_motions(connection, steering, gear), 1e-6);
      if (i == 0) continue;
      EXPECT_GE(connection.cost, all[static_cast<std::size_t>(i) - 1].cost);
    }
    EXPECT_EQ(steering.connect(from, to, gear, 1e-3, all), 0);
  }
}

TEST_P(SteeringModels, KeepsTheTurningRadiusOfACar) {
  const Steering steering(GetParam(), 3, kCosts);
  for (const Motion& primitive : steering.primitives()) {
    const Motion motion = steering.scaled(primitive, 100);
    EXPECT_LE(std::abs(motion.turn), kPi / 2 + 1e-9);
    if (GetParam() == DriveKind::omni || motion.length == 0) continue;
    EXPECT_LE(std::abs(motion.turn), std::abs(motion.length) / 3 + 1e-9);
    EXPECT_FALSE(GetParam() == DriveKind::dubins && motion.length < 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SteeringModels,
                         ::testing::Values(DriveKind::reeds_shepp, DriveKind::dubins,
                                           DriveKind::differential, DriveKind::omni));

TEST(SteeringOfADifferentialDrive, TakesArcsThatCostNoLessThanTheirTurn) {
  const Steering steering(DriveKind::differential, 3, kCosts);
  int arcs = 0;
  for (const Motion& motion : steering.primitives()) {
    arcs += motion.length != 0 && motion.turn != 0 ? 1 : 0;
  }
  EXPECT_EQ(arcs, 4);
  EXPECT_DOUBLE_EQ(steering.cost({1e-3, 1, 0}, 1e-3), kCosts.spin);
  EXPECT_DOUBLE_EQ(steering.cost({5, 1, 0}, 5), 6);
}

TEST(SteeringOfADifferentialDrive, TakesArcsOfEveryRadius) {
  const Steering steering(DriveKind::differential, 3, kCosts);
  for (const double radius : {0.5, 2.0, 7.0, 90.0}) {
    for (const double turn : {0.3, 1.5}) {
      for (const int side : {1, -1}) {
        for (const int ahead : {1, -1}) {
          const Motion arc{ahead * radius * turn, side * turn, 0};
          const Pose from{1, 2, 0.4};
          std::array<Connection, 16> all;
          const int count = steering.connect(from, pose_after(from, arc), 0, 1e9, all);
          EXPECT_TRUE(std::ranges::any_of(std::span(all).first(static_cast<std::size_t>(count)),
                                          [&](const Connection& connection) {
                                            return connection.count == 1 &&
                                                   std::abs(connection.motions[0].length -
                                                            arc.length) < 1e-6;
                                          }))
              << "radius " << radius << ", turn " << side * turn;
        }
      }
    }
  }
}

}  // namespace
}  // namespace wend
