#include "wend/geometry/line.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/arc_distance.hpp"

namespace wend {
namespace {

TEST(Line, HasTheHeadingOfItsDirection) {
  EXPECT_EQ((Line{{1, 1}, {1, 3}}.heading()), kPi / 2);
  EXPECT_EQ((Line{{1, 1}, {0, 1}}.heading()), kPi);
  EXPECT_EQ((Line{{1, 1}, {1, 1}}.heading()), 0);
}

/// Multiples of a quarter: many touch and many are collinear.
Point any_point() { return {*rc::gen::inRange(-12, 16) / 4.0, *rc::gen::inRange(-12, 16) / 4.0}; }

RC_GTEST_PROP(Line, IsAsFarFromPointsAsItsNearestSample, ()) {
  const Line line{any_point(), any_point()};
  const Point point = any_point();
  double least = distance(line.from, point);
  constexpr int kSamples = 400;
  for (int i = 0; i <= kSamples; ++i) {
    least = std::min(least, distance(line.at(i / double{kSamples}), point));
  }
  RC_ASSERT(distance(line, point) <= least + 1e-12);
  RC_ASSERT(distance(line, point) >= least - line.length() / kSamples);
}

RC_GTEST_PROP(Line, IsAsFarFromSquaresAsItsNearestSample, ()) {
  const Line line{any_point(), any_point()};
  const Cell square{0, 0};
  double least = distance(line.from, square);
  constexpr int kSamples = 400;
  for (int i = 0; i <= kSamples; ++i) {
    least = std::min(least, distance(line.at(i / double{kSamples}), square));
  }
  RC_ASSERT(distance(line, square) <= least + 1e-12);
  RC_ASSERT(distance(line, square) >= least - line.length() / kSamples);
}

TEST(Line, TouchesSquaresAtTheirCornersAndEdges) {
  EXPECT_EQ(distance(Line{{-1, 1}, {1, -1}}, Cell{0, 0}), 0);
  EXPECT_EQ(distance(Line{{-1, 1}, {2, 1}}, Cell{0, 0}), 0);
  EXPECT_EQ(distance(Line{{0.5, 0.5}, {0.5, 0.5}}, Cell{0, 0}), 0);
  EXPECT_EQ(distance(Line{{-2, 0.5}, {-1, 0.5}}, Cell{0, 0}), 1);
  EXPECT_DOUBLE_EQ(distance(Line{{-1, 0}, {0, -1}}, Cell{0, 0}), std::sqrt(0.5));
}

}  // namespace
}  // namespace wend
