#include "wend/control/velocity.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "wend/base/random.hpp"

namespace wend {
namespace {

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
