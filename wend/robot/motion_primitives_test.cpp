#include "wend/robot/motion_primitives.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/segment.hpp"

namespace wend {
namespace {

using ::testing::HasSubstr;

MotionPrimitives made(double radius) { return *MotionPrimitives::turning_circle(radius); }

/// A set with one primitive, one cell ahead.
MotionPrimitives::Parts one_step() {
  return {.resolution = std::nullopt,
          .headings = {0, kPi / 2},
          .primitives = {{7, 0, 0, {1, 0}, 1, {{0, 0, 0}, {1, 0, 0}}}}};
}

void expect_refused(const MotionPrimitives::Parts& parts, const std::string& what) {
  const auto refused = MotionPrimitives::make(parts);
  ASSERT_FALSE(refused.has_value()) << what;
  EXPECT_THAT(refused.error().where + ": " + refused.error().message, HasSubstr(what));
}

TEST(MotionPrimitivesTest, TurnWithAtLeastTheirRadius) {
  for (const double radius : {0.5, 1.0, 2.0, 3.7, 8.0, 20.0}) {
    const MotionPrimitives set = made(radius);
    for (const MotionPrimitive& primitive : set.all()) {
      for (std::size_t i = 1; i < primitive.poses.size(); ++i) {
        const Segment segment = segment_between(primitive.poses[i - 1], primitive.poses[i]);
        ASSERT_EQ(segment.course, 0) << "faces along its way";
        if (segment.turn == 0) continue;
        ASSERT_GE(std::abs(segment.length / segment.turn), radius - 1e-9);
      }
    }
  }
}

TEST(MotionPrimitivesTest, OfARadiusOfNothingTurnInPlace) {
  int turns = 0;
  const MotionPrimitives set = made(0);
  for (const MotionPrimitive& primitive : set.all()) {
    if (primitive.from == primitive.to) continue;
    ++turns;
    EXPECT_EQ(primitive.by, (Cell{0, 0}));
  }
  EXPECT_EQ(turns, 32);
}

/// A robot that came from a pose can go back to it.
TEST(MotionPrimitivesTest, CanBeUndone) {
  for (const double radius : {0.0, 1.0, 5.0}) {
    const MotionPrimitives set = made(radius);
    for (const MotionPrimitive& primitive : set.all()) {
      const auto back = set.leaving(primitive.to);
      EXPECT_TRUE(std::ranges::any_of(back, [&](const MotionPrimitive& other) {
        return other.to == primitive.from && other.by.x == -primitive.by.x &&
               other.by.y == -primitive.by.y;
      }));
    }
  }
}

TEST(MotionPrimitivesTest, GetTheWayBack) {
  MotionPrimitives::Parts parts = one_step();
  parts.primitives.push_back({8, 0, 1, {2, 2}, 1.5, {{0, 0, 0}, {2, 2, kPi / 2}}});
  const MotionPrimitives ahead = *MotionPrimitives::make(parts);
  const MotionPrimitives both = ahead.with_ways_back();
  EXPECT_EQ(both.all().size(), 4U);
  ASSERT_EQ(both.leaving(1).size(), 1U);
  const MotionPrimitive& back = both.leaving(1).front();
  EXPECT_EQ(back.to, 0);
  EXPECT_EQ(back.by, (Cell{-2, -2}));
  EXPECT_EQ(back.cost_factor, 1.5);
  EXPECT_NEAR(segment_between(back.poses[0], back.poses[1]).length, -kPi, 1e-12);
  const MotionPrimitives again = both.with_ways_back();
  EXPECT_EQ(again.all().size(), 4U) << "they are there";
}

TEST(MotionPrimitivesTest, LeaveWithEachHeading) {
  const MotionPrimitives set = made(3);
  std::size_t count = 0;
  for (int heading = 0; heading < static_cast<int>(set.headings().size()); ++heading) {
    EXPECT_EQ(set.leaving(heading).size(), 6U) << "straight and two turns, and back";
    for (const MotionPrimitive& primitive : set.leaving(heading)) {
      EXPECT_EQ(primitive.from, heading);
      ++count;
    }
  }
  EXPECT_EQ(count, set.all().size());
}

RC_GTEST_PROP(MotionPrimitivesTest, FindTheNearestHeading, ()) {
  const MotionPrimitives set = made(0);
  const double radians = *rc::gen::inRange(-100'000, 100'000) / 1e4;
  const auto gap = [&](double heading) { return std::abs(normalized_angle(heading - radians)); };
  const int nearest = set.nearest_heading(radians);
  for (const double heading : set.headings()) {
    RC_ASSERT(gap(set.headings()[static_cast<std::size_t>(nearest)]) <= gap(heading));
  }
}

/// A straight line, an arc and a line, as a file samples them.
TEST(MotionPrimitivesTest, JoinSamplesIntoSegments) {
  std::vector<Pose> samples;
  Pose at{0, 0, 0};
  const auto drive = [&](double length, double turn, int pieces) {
    for (int i = 0; i < pieces; ++i) {
      if (samples.empty()) samples.push_back(at);
      at = end_of(Segment{at, length / pieces, turn / pieces, 0});
      samples.push_back({std::round(at.x * 1e4) / 1e4, std::round(at.y * 1e4) / 1e4, at.heading});
    }
  };
  drive(3, 0, 12);
  drive(kPi / 2 * 4, kPi / 2, 20);
  drive(2, 0, 5);
  MotionPrimitives::Parts parts = one_step();
  parts.primitives = {{0, 0, 1, {7, 6}, 1, samples}};
  const auto set = MotionPrimitives::make(parts);
  ASSERT_TRUE(set.has_value()) << set.error().message;
  const std::vector<Pose> poses = set->all().front().poses;
  ASSERT_EQ(poses.size(), 4U);
  EXPECT_NEAR(poses[1].x, 3, 1e-3);
  EXPECT_NEAR(poses[2].y, 4, 1e-3);
  EXPECT_EQ(poses[3], (Pose{7, 6, kPi / 2}));
}

TEST(MotionPrimitivesTest, RefuseWhatIsNoMotion) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MotionPrimitives::Parts parts = one_step();
  parts.primitives.front().to = 2;
  expect_refused(parts, "primitive 0: its headings 0 and 2 must be from 0 to 1");
  parts = one_step();
  parts.primitives.front().cost_factor = 0;
  expect_refused(parts, "its cost factor 0 is not above 0");
  parts = one_step();
  parts.primitives.front().poses.back().x = nan;
  expect_refused(parts, "a pose is not finite");
  parts = one_step();
  parts.primitives.front().poses.back().x = 1.5;
  expect_refused(parts, "its last pose (1.5,0) is not at its vertex (1,0)");
  parts = one_step();
  parts.primitives.front().poses.back().heading = 0.5;
  expect_refused(parts, "its last pose has the heading 0.5 radians instead of 0");
  parts = one_step();
  parts.primitives.front().poses = {{0, 0, 0}};
  expect_refused(parts, "1 poses");
  parts = one_step();
  parts.primitives.front() = {0, 0, 0, {0, 0}, 1, {{0, 0, 0}, {0, 0, 0}}};
  expect_refused(parts, "it does not move");
  parts = one_step();
  parts.headings[1] = 2 * kPi;
  expect_refused(parts, "the headings 0 and 1 are equal");
  parts = one_step();
  parts.headings.clear();
  expect_refused(parts, "at least one heading");
  parts = one_step();
  parts.primitives.clear();
  expect_refused(parts, "no motion primitive");
  parts = one_step();
  parts.resolution = 0;
  expect_refused(parts, "the resolution 0 is not between");
  EXPECT_FALSE(MotionPrimitives::turning_circle(nan).has_value());
  EXPECT_FALSE(MotionPrimitives::turning_circle(-1).has_value());
  EXPECT_FALSE(MotionPrimitives::turning_circle(1e9).has_value());
}

}  // namespace
}  // namespace wend
