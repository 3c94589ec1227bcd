#include "wend/space/lattice/car_space.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace wend {
namespace {

constexpr std::int64_t kStraight = CarUnits::kStraight;
constexpr std::int64_t kTurn = CarUnits::kTurn;
constexpr std::int64_t kEqualTurns = kStraight / 2;  // these turns weigh a whole number of units

int sign(long double number) { return (number > 0 ? 1 : 0) - (number < 0 ? 1 : 0); }

/// Takes small numbers. pi / 2 is irrational, so the sign is 0 only if both are 0.
int sign_of_length(std::int64_t straight, std::int64_t turns) {
  return sign(static_cast<long double>(straight) +
              static_cast<long double>(turns) * std::numbers::pi_v<long double> / 2);
}

int sign_of_units(std::int64_t straight, std::int64_t turns) {
  return sign(static_cast<long double>(straight * kStraight + turns * kTurn));
}

/// The sums that are hardest to tell apart differ by nearly nothing.
RC_GTEST_PROP(CarUnits, CompareSumsOfMovesAsTheirTrueLengths, ()) {
  const auto turns = *rc::gen::inRange<std::int64_t>(-kEqualTurns + 1, kEqualTurns);
  const auto nearest =
      static_cast<std::int64_t>(std::floor(-static_cast<double>(turns) * std::numbers::pi / 2));
  const auto straight = nearest + *rc::gen::inRange<std::int64_t>(-3, 5);
  RC_ASSERT(sign_of_units(straight, turns) == sign_of_length(straight, turns));
}

TEST(CarUnits, CompareTheHardestSumsThereAre) {
  for (std::int64_t turns = 1; turns < kEqualTurns; ++turns) {
    const auto nearest =
        static_cast<std::int64_t>(std::floor(static_cast<double>(turns) * std::numbers::pi / 2));
    for (const std::int64_t straight : {nearest, nearest + 1}) {
      ASSERT_EQ(sign_of_units(straight, -turns), sign_of_length(straight, -turns)) << turns;
    }
  }
}

/// Where the guarantee ends.
TEST(CarUnits, MeanOneLengthByOneSumUpToTheirOwnSize) {
  EXPECT_EQ(sign_of_units(kTurn / 2, -kEqualTurns), 0);
  EXPECT_NE(sign_of_length(kTurn / 2, -kEqualTurns), 0);
}

TEST(CarUnits, AreEvenForTheMeanOfTwoMultipliers) {
  EXPECT_EQ(kStraight % 2, 0);
  EXPECT_EQ(kTurn % 2, 0);
}

TEST(CarUnits, HoldPathsOfSome60000UnitsIn32Bits) {
  EXPECT_GE(UINT32_MAX / CarUnits::kStraight, 60'000U);
}

}  // namespace
}  // namespace wend
