// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/orientation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "wend/geometry/angle.hpp"

namespace wend_nav2 {
namespace {

using testing::HasSubstr;

/// A turn by `lean` about an axis in the plane, after a turn by `heading` about z.
Quaternion orientation_of(double heading, double lean, double axis) {
  const double x = std::sin(lean / 2) * std::cos(axis);
  const double y = std::sin(lean / 2) * std::sin(axis);
  const double w = std::cos(lean / 2);
  const double s = std::sin(heading / 2);
  const double c = std::cos(heading / 2);
  return {x * c + y * s, y * c - x * s, w * s, w * c};
}

std::string why_refused(const Quaternion& orientation, Tilt tilt = Tilt::flat) {
  const auto heading = heading_of(orientation, tilt);
  return heading ? "none" : heading.error();
}

RC_GTEST_PROP(Orientation, ATurnAboutZHasItsHeadingWhateverItsLength, ()) {
  const double heading = *rc::gen::inRange(-3141, 3142) / 1000.0;
  const double length = *rc::gen::inRange(955, 1045) / 1000.0;
  const auto read = heading_of(
      {0, 0, length * std::sin(heading / 2), length * std::cos(heading / 2)}, Tilt::flat);
  RC_ASSERT(read.has_value());
  RC_ASSERT(std::abs(wend::normalized_angle(*read - heading)) < 1e-9);
}

RC_GTEST_PROP(Orientation, WhatLeansIsRefusedFromALimitOn, ()) {
  const double heading = *rc::gen::inRange(-3141, 3142) / 1000.0;
  const double axis = *rc::gen::inRange(-3141, 3142) / 1000.0;
  const int degrees = *rc::gen::inRange(0, 181);
  const Quaternion leaning = orientation_of(heading, degrees * wend::kPi / 180, axis);
  RC_ASSERT(heading_of(leaning, Tilt::flat).has_value() == (degrees < 3));
  if (degrees != 45) RC_ASSERT(heading_of(leaning, Tilt::slope).has_value() == (degrees < 45));
}

TEST(Orientation, WhatIsNoneIsRefusedWithTheReason) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(why_refused({0, 0, 0, 0}), HasSubstr("has the length 0"));
  EXPECT_THAT(why_refused({0, 0, 1e-300, 0}), HasSubstr("has the length 0"));
  EXPECT_THAT(why_refused({0, 0, 1, 1}), HasSubstr("has the length 1.414, not 1"));
  EXPECT_THAT(why_refused({0, 0, 0, 0.5}), HasSubstr("has the length 0.5, not 1"));
  EXPECT_THAT(why_refused({1, 0, 0, 0}), HasSubstr("leans 180 degrees"));
  EXPECT_THAT(why_refused({.5, .5, .5, .5}, Tilt::slope), HasSubstr("leans 90 degrees"));
  for (const Quaternion& endless : {Quaternion{kNan, 0, 0, 1}, Quaternion{0, 0, kNan, 1},
                                    Quaternion{0, 0, INFINITY, 1}, Quaternion{0, 0, 1e300, 1}}) {
    EXPECT_THAT(why_refused(endless), HasSubstr("NaN or infinity"));
  }
  EXPECT_EQ(why_refused({0, 0, 0.7, 0.7}), "none") << "as people type a quarter turn";
}

}  // namespace
}  // namespace wend_nav2
