#include "wend/geometry/segment.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

rc::Gen<double> number(double least, double greatest) {
  return rc::gen::map(rc::gen::inRange(0, 1'000'001),
                      [=](int n) { return least + (greatest - least) * n / 1e6; });
}

Pose any_pose() { return {*number(-5, 5), *number(-5, 5), *number(-3.1, 3.1)}; }

void expect_near(const Pose& a, const Pose& b) {
  RC_ASSERT(distance(a.point(), b.point()) < 1e-9);
  RC_ASSERT(std::abs(normalized_angle(a.heading - b.heading)) < 1e-9);
}

RC_GTEST_PROP(SegmentTest, JoinsItsPoses, ()) {
  const Pose from = any_pose();
  const Pose to = any_pose();
  const Segment segment = segment_between(from, to);
  expect_near(pose_on(segment, 0), from);
  expect_near(end_of(segment), to);
  RC_ASSERT(std::abs(segment.course) <= kPi / 2 + 1e-8);
  RC_ASSERT(std::abs(segment.turn) <= kPi);
}

/// Constant velocity in its own frame: each of n equal parts moves the robot alike, seen from where it is.
RC_GTEST_PROP(SegmentTest, MovesAlikeInEveryPart, ()) {
  const Segment segment = segment_between(any_pose(), any_pose());
  const auto seen_from = [](const Pose& a, const Pose& b) {
    const double c = std::cos(a.heading);
    const double s = std::sin(a.heading);
    return Pose{c * (b.x - a.x) + s * (b.y - a.y), c * (b.y - a.y) - s * (b.x - a.x),
                normalized_angle(b.heading - a.heading)};
  };
  const Pose first = seen_from(pose_on(segment, 0), pose_on(segment, 0.125));
  for (int i = 1; i < 8; ++i) {
    expect_near(seen_from(pose_on(segment, i / 8.0), pose_on(segment, (i + 1) / 8.0)), first);
  }
}

RC_GTEST_PROP(SegmentTest, HasHalvesThatFollowEachOther, ()) {
  const Segment segment = segment_between(any_pose(), any_pose());
  const auto halves = halves_of(segment);
  expect_near(end_of(halves[0]), pose_on(segment, 0.5));
  expect_near(pose_on(halves[1], 0.5), pose_on(segment, 0.75));
  expect_near(end_of(halves[1]), end_of(segment));
}

RC_GTEST_PROP(SegmentTest, OfACarIsItsArc, ()) {
  const Arc arc{any_pose(), *number(-4, 4), *number(-0.7, 0.7)};
  RC_PRE(std::abs(arc.length) > 1e-3);
  const Segment segment = segment_between(arc.from, end_of(arc));
  RC_ASSERT(std::abs(segment.length - arc.length) < 1e-6);
  RC_ASSERT(std::abs(segment.turn - arc.turn()) < 1e-9);
  RC_ASSERT(std::abs(segment.course) < 1e-6);
}

TEST(SegmentTest, TurnsInPlaceAndMovesSideways) {
  const Segment turn = segment_between({1, 2, 0.5}, {1, 2, -0.25});
  EXPECT_EQ(turn.length, 0);
  EXPECT_DOUBLE_EQ(turn.turn, -0.75);
  EXPECT_EQ(pose_on(turn, 0.5).point(), (Point{1, 2}));
  const Segment aside = segment_between({0, 0, 0}, {0, -2, 0});
  EXPECT_DOUBLE_EQ(aside.length, 2);
  EXPECT_DOUBLE_EQ(aside.course, -kPi / 2);
  EXPECT_EQ(aside.turn, 0);
  EXPECT_DOUBLE_EQ(segment_between({0, 0, 0}, {-3, 0, 0}).length, -3) << "in reverse";
}

}  // namespace
}  // namespace wend
