#include "wend/geometry/arc_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "tests/testing/random_arc.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

using test::random_arc;
using test::text_of;

// The arcs begin on a grid of this size; points and squares also lie a few cells outside of it.
constexpr int kSize = 5;

Cell random_square(Random& random, const Arc& arc) {
  if (random.chance(0.5)) return {random.between(-3, kSize + 2), random.between(-3, kSize + 2)};
  const Point near = pose_on(arc, random.uniform() * arc.length).point();
  return {static_cast<int>(std::floor(near.x)) + random.between(-1, 1),
          static_cast<int>(std::floor(near.y)) + random.between(-1, 1)};
}

/// A random point, sometimes a corner of the grid.
Point random_point(Random& random) {
  const Point point{test::number_between(random, -3, kSize + 3),
                    test::number_between(random, -3, kSize + 3)};
  return random.chance(0.5) ? point : Point{std::round(point.x), std::round(point.y)};
}

/// The least distance along an arc: by sampling, and by ternary search around each sample that is
/// lower than its neighbours.
double brute_force(const Arc& arc, const std::function<double(Point)>& distance_from) {
  constexpr int kSamples = 400;
  constexpr int kThirds = 45;
  const auto at = [&](double sample) {
    return distance_from(pose_on(arc, sample / kSamples * arc.length).point());
  };
  std::array<double, kSamples + 1> values{};
  for (int i = 0; i <= kSamples; ++i) values[static_cast<std::size_t>(i)] = at(i);
  double least = *std::min_element(values.begin(), values.end());
  for (std::size_t i = 0; i <= kSamples; ++i) {
    // Between two samples it falls by no more than half the way between them.
    if (values[i] > least + std::abs(arc.length) / kSamples) continue;
    if ((i > 0 && values[i - 1] < values[i]) || (i < kSamples && values[i + 1] < values[i])) {
      continue;
    }
    double low = std::max(static_cast<double>(i) - 1, 0.0);
    double high = std::min(static_cast<double>(i) + 1, kSamples + 0.0);
    for (int k = 0; k < kThirds; ++k) {
      const double third = (high - low) / 3;
      if (at(low + third) <= at(high - third)) {
        high -= third;
      } else {
        low += third;
      }
    }
    least = std::min(least, at((low + high) / 2));
  }
  return least;
}

double between_point_and_square(Point point, Cell square) {
  const Point nearest{std::clamp(point.x, square.x + 0.0, square.x + 1.0),
                      std::clamp(point.y, square.y + 0.0, square.y + 1.0)};
  return std::sqrt(std::pow(point.x - nearest.x, 2) + std::pow(point.y - nearest.y, 2));
}

TEST(ArcDistance, ToAPointIsThatOfTheNearestPointOfTheArc) {
  for (std::uint64_t seed = 1; seed <= 2000 && !HasFailure(); ++seed) {
    Random random(seed);
    const Arc arc = random_arc(random, kSize, kSize);
    const Point point = random_point(random);
    const double expected = brute_force(arc, [&](Point on_arc) { return distance(on_arc, point); });
    ASSERT_NEAR(distance(arc, point), expected, 1e-7)
        << "seed " << seed << ": " << text_of(arc) << ", to (" << point.x << "," << point.y << ")";
  }
}

TEST(ArcDistance, ToASquareIsThatOfTheNearestPointOfTheArc) {
  int crossing = 0;
  int apart = 0;
  for (std::uint64_t seed = 1; seed <= 3000 && !HasFailure(); ++seed) {
    Random random(seed);
    const Arc arc = random_arc(random, kSize, kSize);
    const Cell square = random_square(random, arc);
    const double expected =
        brute_force(arc, [&](Point on_arc) { return between_point_and_square(on_arc, square); });
    const double found = distance(arc, square);
    ASSERT_NEAR(found, expected, 1e-7) << "seed " << seed << ": " << text_of(arc) << ", to ("
                                       << square.x << "," << square.y << ")";
    ASSERT_TRUE(expected > 0 || found == 0) << "seed " << seed << ": " << found;
    ++(expected == 0 ? crossing : apart);
  }
  EXPECT_GT(crossing, 500);
  EXPECT_GT(apart, 500);
}

/// An arc that is driven backwards has the same points.
TEST(ArcDistance, IsTheSameDrivenBack) {
  for (std::uint64_t seed = 1; seed <= 3000 && !HasFailure(); ++seed) {
    Random random(seed);
    const Arc arc = random_arc(random, kSize, kSize);
    const Arc back{end_of(arc), -arc.length, arc.curvature};
    const Cell square = random_square(random, arc);
    const Point point = random_point(random);
    ASSERT_NEAR(distance(arc, square), distance(back, square), 1e-12) << "seed " << seed;
    ASSERT_NEAR(distance(arc, point), distance(back, point), 1e-12) << "seed " << seed;
  }
}

TEST(ArcDistance, IsKnownOfQuarterCircles) {
  const Arc arc = arc_to({0, 0, 0}, {1, 1});  // around (0,1)
  EXPECT_DOUBLE_EQ(distance(arc, Cell{1, -1}), std::sqrt(2) - 1);
  EXPECT_DOUBLE_EQ(distance(arc, Point{1, 0}), std::sqrt(2) - 1);
  EXPECT_DOUBLE_EQ(distance(arc, Cell{2, -1}), std::sqrt(5) - 1);
  EXPECT_DOUBLE_EQ(distance(arc, Cell{2, -2}), std::sqrt(8) - 1);
  EXPECT_DOUBLE_EQ(distance(arc, Cell{2, 1}), 1);
  EXPECT_DOUBLE_EQ(distance(arc, Cell{0, 2}), 1);
  EXPECT_DOUBLE_EQ(distance(arc, Cell{-2, -2}), std::sqrt(2));
  EXPECT_DOUBLE_EQ(distance(arc, Point{0, 1}), 1) << "its centre";
  for (const Cell touched : {Cell{0, 0}, {-1, 0}, {-1, -1}, {0, -1}, {1, 0}, {1, 1}, {0, 1}}) {
    EXPECT_EQ(distance(arc, touched), 0) << touched.x << "," << touched.y;
  }
}

TEST(ArcDistance, SeesWhereACirclePassesTheMiddleOfASide) {
  const Arc circle{{0.5, -2, 0}, 4 * kPi, 0.5};  // around (0.5, 0), radius 2
  EXPECT_DOUBLE_EQ(distance(circle, Cell{0, 3}), 1);
  EXPECT_DOUBLE_EQ(distance(circle, Cell{0, -4}), 1);
  EXPECT_DOUBLE_EQ(distance(circle, Cell{0, 0}), 2 - std::hypot(0.5, 1)) << "inside of it";
  EXPECT_EQ(distance(circle, Cell{0, 2}), 0) << "touches the middle of its side";
  const Arc right_half{circle.from, 2 * kPi, 0.5};
  EXPECT_DOUBLE_EQ(distance(right_half, Cell{-4, 0}), std::hypot(3.5, 1))
      << "the middle of the side is abreast of the other half";
}

/// A circle a million cells wide: its centre is far, its points are near.
TEST(ArcDistance, StaysExactWhereArcsAreNearlyStraight) {
  const Arc nearly{{0, 0, 0}, 10, 1e-12};
  EXPECT_NEAR(distance(nearly, Point{5, 3}), 3 - 12.5e-12, 1e-14);
  EXPECT_NEAR(distance(nearly, Cell{4, 2}), 2 - 12.5e-12, 1e-14);
  EXPECT_NEAR(distance(nearly, Cell{12, -1}), 2, 1e-14);
}

TEST(ArcDistance, OfNoLengthIsThatOfAPoint) {
  const Arc still{{1.5, 2, 1}, 0, 0.25};
  EXPECT_EQ(distance(still, Point{1.5, 5}), 3);
  EXPECT_EQ(distance(still, Cell{1, 2}), 0);
  EXPECT_EQ(distance(still, Cell{3, 2}), 1.5);
  EXPECT_EQ(distance(Point{1.5, 2}, Cell{3, 2}), 1.5);
  EXPECT_EQ(distance(Point{6, 6}, Cell{2, 1}), 5);
}

}  // namespace
}  // namespace wend
