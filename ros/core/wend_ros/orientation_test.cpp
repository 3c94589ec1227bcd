// Which quaternions are headings: against rotations made of axis and angle.

#include "wend_ros/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "wend/geometry/angle.hpp"

namespace wend_ros {
namespace {

/// A turn by `yaw` about +z, then a tilt about the axis in the ground at `course`.
Orientation tilted(double yaw, double tilt, double course) {
  const double half = tilt / 2;
  const double s = std::sin(half);
  const Orientation lean{s * std::cos(course), s * std::sin(course), 0, std::cos(half)};
  const Orientation turn{0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
  return {lean.x * turn.w + lean.y * turn.z, lean.y * turn.w - lean.x * turn.z, lean.w * turn.z,
          lean.w * turn.w};
}

Orientation scaled(const Orientation& turn, double factor) {
  return {factor * turn.x, factor * turn.y, factor * turn.z, factor * turn.w};
}

std::string fault_of(const Orientation& turn) {
  const auto heading = heading_of(turn);
  return heading ? std::string() : heading.error();
}

TEST(Orientation, OfAFlatTurnIsItsHeading) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> draw(-wend::kPi, wend::kPi);
  for (int i = 0; i < 1000; ++i) {
    const double yaw = draw(random);
    const Orientation turn = tilted(yaw, 0, 0);
    for (const double factor : {1.0, -1.0, 1.0009, 0.9991}) {
      const auto heading = heading_of(scaled(turn, factor));
      ASSERT_TRUE(heading) << heading.error();
      ASSERT_NEAR(wend::normalized_angle(*heading - yaw), 0, 1e-9);
    }
  }
}

TEST(Orientation, IsRefusedWhereItIsNoUnitQuaternion) {
  EXPECT_EQ(fault_of({0, 0, 0, 0}), "has the orientation (0, 0, 0, 0), whose length is 0, not 1");
  EXPECT_EQ(fault_of({0, 0, 0, 1.002}),
            "has the orientation (0, 0, 0, 1.002), whose length is 1.002, not 1");
  EXPECT_EQ(fault_of({0, 0, 0, 0.5}),
            "has the orientation (0, 0, 0, 0.5), whose length is 0.5, not 1");
  EXPECT_NE(fault_of({0, 0, 1e-300, 0}), "");
  EXPECT_NE(fault_of({0, 0, 1e300, 1e300}), "");
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault_of({0, 0, none, 1}), "contains NaN or infinity");
  EXPECT_EQ(fault_of({std::numeric_limits<double>::infinity(), 0, 0, 1}),
            "contains NaN or infinity");
}

TEST(Orientation, IsRefusedWhereItIsTilted) {
  EXPECT_EQ(fault_of({1, 0, 0, 0}),
            "has the orientation (1, 0, 0, 0), which is tilted by 180 degrees");
  EXPECT_EQ(fault_of({0.5, 0.5, 0.5, 0.5}),
            "has the orientation (0.5, 0.5, 0.5, 0.5), which is tilted by 90 degrees");
  std::mt19937 random(2);
  std::uniform_real_distribution<double> draw(-wend::kPi, wend::kPi);
  for (int i = 0; i < 1000; ++i) {
    const double tilt = std::abs(draw(random));
    const Orientation turn = tilted(draw(random), tilt, draw(random));
    ASSERT_EQ(fault_of(turn).empty(), tilt <= kLargestTilt) << tilt;
    const bool lies = tilt > wend::radians_from(45) && tilt < wend::radians_from(135);
    ASSERT_EQ(heading_of_frame(turn).has_value(), !lies) << tilt;
  }
}

TEST(Orientation, OfAFrameUpsideDownIsThatOfItsFront) {
  for (const double yaw : {0.0, 1.0, -2.5}) {
    const auto heading = heading_of_frame(tilted(yaw, wend::kPi, 0));
    ASSERT_TRUE(heading);
    EXPECT_NEAR(wend::normalized_angle(*heading + yaw), 0, 1e-9);
  }
}

}  // namespace
}  // namespace wend_ros
