#include "wend/geometry/angle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace wend {
namespace {

RC_GTEST_PROP(NormalizedAngle, IsTheSameDirectionInTheHalfOpenRange, ()) {
  const double radians = *rc::gen::inRange(-100000, 100000) / 1000.0;
  const double normalized = normalized_angle(radians);
  RC_ASSERT(normalized > -kPi);
  RC_ASSERT(normalized <= kPi);
  RC_ASSERT(std::abs(std::cos(normalized) - std::cos(radians)) < 1e-12);
  RC_ASSERT(std::abs(std::sin(normalized) - std::sin(radians)) < 1e-12);
  RC_ASSERT(normalized_angle(normalized) == normalized);
}

TEST(NormalizedAngle, LeavesAnglesInTheRangeAsTheyAre) {
  for (const double radians : {0.0, 1.0, -1.0, 3.14, -3.14, kPi}) {
    EXPECT_EQ(normalized_angle(radians), radians);
  }
}

TEST(NormalizedAngle, TurnsMinusPiIntoPi) {
  EXPECT_EQ(normalized_angle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(normalized_angle(1.5 * kPi), -0.5 * kPi);
}

TEST(Angles, ConvertToDegreesAndBack) {
  EXPECT_DOUBLE_EQ(degrees_from(kPi), 180);
  EXPECT_DOUBLE_EQ(radians_from(-90), -kPi / 2);
  for (int degrees = -360; degrees <= 360; ++degrees) {
    EXPECT_NEAR(degrees_from(radians_from(degrees)), degrees, 1e-12);
  }
}

}  // namespace
}  // namespace wend
