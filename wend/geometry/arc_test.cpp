#include "wend/geometry/arc.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

TEST(Arc, IsALineAheadOrInReverse) {
  const Arc ahead = arc_to({1, 2, 0}, {4, 2});
  EXPECT_EQ(ahead.length, 3);
  EXPECT_EQ(ahead.curvature, 0);
  EXPECT_EQ(arc_to({1, 2, kPi}, {4, 2}).length, -3);
  EXPECT_EQ(arc_to({1, 2, 1}, {1, 2}).length, 0);
}

TEST(Arc, IsAHalfCircleToAPointBeside) {
  const Arc arc = arc_to({0, 0, 0}, {0, 4});
  EXPECT_NEAR(arc.length, 2 * kPi, 1e-15);
  EXPECT_NEAR(arc.curvature, 0.5, 1e-15);
}

double in(double least, double greatest) {
  constexpr int kSteps = 1000000;
  return least + (greatest - least) * *rc::gen::inRange(0, kSteps + 1) / kSteps;
}

/// Integrates the car's motion in small steps, by the midpoint rule.
Pose driven(const Arc& arc, int steps) {
  Pose pose = arc.from;
  const double step = arc.length / steps;
  for (int i = 0; i < steps; ++i) {
    const double middle = pose.heading + arc.curvature * step / 2;
    pose = {pose.x + step * std::cos(middle), pose.y + step * std::sin(middle),
            pose.heading + arc.curvature * step};
  }
  return pose;
}

RC_GTEST_PROP(Arc, EndsInItsPointAsACarDrives, ()) {
  const Pose from{in(-9, 9), in(-9, 9), in(-7, 7)};
  const Point to{in(-9, 9), in(-9, 9)};
  const Arc arc = arc_to(from, to);
  RC_ASSERT(std::abs(arc.turn()) <= kPi + 1e-9);
  RC_ASSERT(distance(end_of(arc).point(), to) < 1e-9);
  const Pose end = driven(arc, 2000);
  RC_ASSERT(distance(end.point(), to) < 1e-4);
  RC_ASSERT(std::abs(normalized_angle(end.heading - end_of(arc).heading)) < 1e-6);
}

}  // namespace
}  // namespace wend
