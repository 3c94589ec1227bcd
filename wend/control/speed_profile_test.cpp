#include "wend/control/speed_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr SpeedProfileOptions kOptions{
    .limits = {.speed = 3, .turn_rate = 2, .acceleration = 1, .turn_acceleration = 100},
    .lateral_acceleration = 2};

/// 10 m straight, half a circle to the left, 10 m straight back.
MapPolyline hairpin(double radius) {
  std::vector<MapPoint> points{{-10, 0}};
  for (int i = 0; i <= 180; ++i) {
    const double angle = radians_from(i);
    points.push_back({radius * std::sin(angle), radius * (1 - std::cos(angle))});
  }
  points.push_back({-10, 2 * radius});
  return MapPolyline(points);
}

TEST(SpeedProfile, AllowsFullSpeedOnALineAndStandsAtItsEnd) {
  const SpeedProfile profile(MapPolyline({{0, 0}, {20, 0}}), kOptions);
  EXPECT_EQ(profile.at(0), 3);
  EXPECT_EQ(profile.at(15), 3);
  EXPECT_NEAR(profile.at(18), std::sqrt(2 * 2.0), 1e-6) << "it brakes by 1 m/s^2";
  EXPECT_EQ(profile.at(20), kOptions.min_speed);
  EXPECT_EQ(profile.at(1e9), kOptions.min_speed);
}

TEST(SpeedProfile, KeepsTheLateralAccelerationAndTheTurnRateInABend) {
  const SpeedProfile wide(hairpin(2), kOptions);
  EXPECT_NEAR(wide.at(10 + kPi), std::sqrt(2 * 2.0), 0.02);
  const SpeedProfile narrow(hairpin(0.4), kOptions);
  EXPECT_NEAR(narrow.at(10 + 0.2 * kPi), 2 * 0.4, 0.02) << "2 rad/s on a circle of 0.4 m";
}

TEST(SpeedProfile, BrakesInTimeForABend) {
  const MapPolyline line = hairpin(0.4);
  const SpeedProfile profile(line, kOptions);
  constexpr double kStep = 0.01;
  for (double along = 0; along + kStep <= line.length(); along += kStep) {
    const double now = profile.at(along);
    const double next = profile.at(along + kStep);
    ASSERT_LE(now * now, next * next + 2 * kOptions.limits.acceleration * kStep + 0.01) << along;
  }
  EXPECT_GT(profile.at(0), 2.9);
  EXPECT_LT(profile.at(9), 1.85);
}

TEST(SpeedProfile, IsSlowTheLookaheadBeforeABend) {
  SpeedProfileOptions options = kOptions;
  options.lookahead = 1;
  EXPECT_LT(SpeedProfile(hairpin(0.4), options).at(9.25), 0.9);
  EXPECT_GT(SpeedProfile(hairpin(0.4), kOptions).at(9.25), 1.2);
}

TEST(SpeedProfile, OfAPointOrAVeryLongLineIsMadeToo) {
  EXPECT_EQ(SpeedProfile(MapPolyline({{3, 3}}), kOptions).at(0), kOptions.min_speed);
  EXPECT_EQ(SpeedProfile(MapPolyline({{0, 0}, {1e9, 0}}), kOptions).at(5), 3);
}

}  // namespace
}  // namespace wend
