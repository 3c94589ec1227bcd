#include "wend/geometry/trigonometry.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "wend/base/random.hpp"

namespace wend {
namespace {

/// Numbers of every size from 1e-8 to `largest`, of either sign.
double number_up_to(double largest, Random& random) {
  const double size = std::pow(10, -8 + random.uniform() * (std::log10(largest) + 8));
  return random.chance(0.5) ? size : -size;
}

TEST(SineAndCosine, AreAsThoseOfTheStandardLibrary) {
  Random random(1);
  for (int i = 0; i < 200000; ++i) {
    const double angle = number_up_to(1e6, random);
    const SineCosine both = sine_and_cosine(angle);
    ASSERT_NEAR(both.sine, std::sin(angle), 3.2e-16) << angle;
    ASSERT_NEAR(both.cosine, std::cos(angle), 3.2e-16) << angle;
  }
}

TEST(SineAndCosine, AreExactToAFewUnitsNearTheirZeros) {
  for (int quarters = -40; quarters <= 40; ++quarters) {
    const double angle = quarters * (kPi / 2);
    const SineCosine both = sine_and_cosine(angle);
    const double tolerance = 1e-15;  // relative
    EXPECT_NEAR(both.sine, std::sin(angle), tolerance * std::abs(std::sin(angle))) << quarters;
    EXPECT_NEAR(both.cosine, std::cos(angle), tolerance * std::abs(std::cos(angle))) << quarters;
  }
}

TEST(SineAndCosine, LoseAccuracyOfLargeAnglesAsTheySay) {
  for (const double angle : {1e6, 1e9, -3e12}) {
    EXPECT_NEAR(sine_and_cosine(angle).sine, std::sin(angle), 4e-17 * std::abs(angle));
  }
  EXPECT_TRUE(std::isnan(sine_and_cosine(std::numeric_limits<double>::infinity()).sine));
  EXPECT_TRUE(std::isnan(sine_and_cosine(std::numeric_limits<double>::quiet_NaN()).cosine));
}

TEST(Tangent, IsThatOfTheStandardLibrary) {
  Random random(4);
  for (int i = 0; i < 200000; ++i) {
    const double angle = (kPi / 2 - 1e-3) * (2 * random.uniform() - 1);
    ASSERT_NEAR(tangent(angle), std::tan(angle), 1e-12 * std::abs(std::tan(angle))) << angle;
  }
}

TEST(Hypotenuse, IsThatOfTheStandardLibrary) {
  Random random(5);
  for (int i = 0; i < 200000; ++i) {
    const double x = number_up_to(1e6, random);
    const double y = number_up_to(1e6, random);
    ASSERT_NEAR(hypotenuse(x, y), std::hypot(x, y), 3e-16 * std::hypot(x, y)) << x << ' ' << y;
  }
  EXPECT_EQ(hypotenuse(-3, 4), 5);
}

TEST(ArcTangent, IsThatOfTheStandardLibrary) {
  Random random(2);
  for (int i = 0; i < 200000; ++i) {
    const double x = number_up_to(1e4, random);
    const double y = number_up_to(1e4, random);
    const double expected = std::atan2(y, x);
    ASSERT_NEAR(arc_tangent(y, x), expected, 8e-16 * std::abs(expected)) << y << ' ' << x;
  }
}

TEST(ArcTangent, IsExactOnTheAxesAndDiagonals) {
  EXPECT_EQ(arc_tangent(0, 3), 0);
  EXPECT_EQ(arc_tangent(-0.0, 3), 0);
  EXPECT_EQ(arc_tangent(2, 2), kPi / 4);
  EXPECT_EQ(arc_tangent(5, 0), kPi / 2);
  EXPECT_EQ(arc_tangent(0, -3), kPi);
  EXPECT_EQ(arc_tangent(-0.0, -3), kPi);
  EXPECT_EQ(arc_tangent(-5, -0.0), -kPi / 2);
  EXPECT_EQ(arc_tangent(-2, -2), -3 * (kPi / 4));
  EXPECT_EQ(arc_tangent(0, 0), 0);
}

// These numbers were computed once. Where a platform has others, its plans differ from those of the rest.
TEST(Trigonometry, HasTheSameBitsEverywhere) {
  Random random(3);
  std::uint64_t bits = 0;
  const auto note = [&bits](double value) {
    bits = std::rotl(bits, 7) ^ std::bit_cast<std::uint64_t>(value);
  };
  for (int i = 0; i < 10000; ++i) {
    const double angle = 2000 * random.uniform() - 1000;
    const SineCosine both = sine_and_cosine(angle);
    note(both.sine);
    note(both.cosine);
    const double x = random.uniform() - 0.5;
    const double y = random.uniform() - 0.5;
    note(arc_tangent(y, x));
    note(tangent(angle));
    note(hypotenuse(x, y));
  }
  EXPECT_EQ(bits, 8243595718480243322U);
}

}  // namespace
}  // namespace wend
