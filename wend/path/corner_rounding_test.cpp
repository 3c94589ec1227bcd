#include "wend/path/corner_rounding.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

Corner turning_by(double angle, double before = 100, double after = 100) {
  return Corner({-before, 0}, {0, 0}, {after * std::cos(angle), after * std::sin(angle)});
}

TEST(Corner, HasNoRadiusWithoutAWindow) {
  for (const double degrees : {1e-3, 10.0, 84.0, 90.0, 170.0}) {
    EXPECT_EQ(turning_by(radians_from(degrees)).radius(0), 0) << degrees;
  }
  EXPECT_TRUE(std::isinf(turning_by(0).radius(0))) << "there is no corner";
}

TEST(Corner, ThatTurnsBackHasNoRadiusWithAnyWindow) {
  EXPECT_EQ(Corner({0, 0}, {4, 0}, {1, 0}).radius(10), 0);
}

/// The kink that the circle through its three points told to be 3.8 m wide.
TEST(Corner, OfAKinkIsAsTightAsItsWindow) {
  const double radius = turning_by(radians_from(84)).radius(0.05);
  EXPECT_NEAR(radius, 0.05 / (1 / std::cos(radians_from(42)) - 1), 1e-12);
  EXPECT_LT(radius, 0.15);
}

TEST(Corner, IsRoundedNoFartherThanTheMiddleOfItsLines) {
  EXPECT_NEAR(turning_by(kPi / 2, 3, 1).radius(1000), 0.5, 1e-12);
}

/// The arc's middle lies on the bisector, radius / cos(turn / 2) - radius from the corner; it begins
/// radius tan(turn / 2) before it.
RC_GTEST_PROP(Corner, ArcKeepsWithinTheWindowAndTheLines, ()) {
  const double turn = *rc::gen::inRange(1, 1799) / 1800.0 * kPi;
  const double before = *rc::gen::inRange(1, 100) / 7.0;
  const double after = *rc::gen::inRange(1, 100) / 7.0;
  const double window = *rc::gen::inRange(1, 100) / 31.0;
  const double radius = turning_by(turn, before, after).radius(window);
  const double off = radius / std::cos(turn / 2) - radius;
  const double begins = radius * std::tan(turn / 2);
  const double middle = std::min(before, after) / 2;
  RC_ASSERT(off <= window * (1 + 1e-9) && begins <= middle * (1 + 1e-9));
  RC_ASSERT(off >= window * (1 - 1e-6) || begins >= middle * (1 - 1e-6));
}

RC_GTEST_PROP(Corner, WidestTurnIsWhereTheRadiusIsMet, ()) {
  const double turn = *rc::gen::inRange(1, 1799) / 1800.0 * kPi;
  const Corner corner = turning_by(turn, 3, 2);
  const double window = *rc::gen::inRange(1, 100) / 31.0;
  const double radius = corner.radius(window);
  RC_ASSERT(corner.half_turn_tangent() <= corner.widest_half_turn(radius * (1 - 1e-6), window));
  RC_ASSERT(corner.half_turn_tangent() >= corner.widest_half_turn(radius * (1 + 1e-6), window));
}

TEST(Corner, OfTheSnippetIsARightAngle) {
  EXPECT_NEAR(Corner({0, 0}, {1, 0}, {1, 1}).radius(0.1), 0.1 / (std::numbers::sqrt2 - 1), 1e-12);
}

}  // namespace
}  // namespace wend
