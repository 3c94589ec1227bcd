#include "wend/geometry/polygon.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/testing/random_polygon.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

using ::testing::HasSubstr;

const std::vector<Point> kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

/// How often the outline winds around a point that is not on it: an independent test of "inside".
int winding_number(const Polygon& polygon, Point point) {
  double turned = 0;
  for (std::size_t i = 0; i < polygon.corners().size(); ++i) {
    const Line edge = polygon.edge(i);
    const double from = std::atan2(edge.from.y - point.y, edge.from.x - point.x);
    const double to = std::atan2(edge.to.y - point.y, edge.to.x - point.x);
    turned += normalized_angle(to - from);
  }
  return static_cast<int>(std::lround(turned / (2 * kPi)));
}

RC_GTEST_PROP(Polygon, ContainsWhatItsOutlineWindsAround, ()) {
  const Polygon polygon = test::random_polygon();
  const Point point{*rc::gen::inRange(-300, 300) / 100.0, *rc::gen::inRange(-300, 300) / 100.0};
  if (distance_to_outline(polygon, point) < 1e-9) {
    RC_DISCARD("on the outline");
  }
  RC_ASSERT(polygon.contains(point) == (winding_number(polygon, point) == 1));
}

RC_GTEST_PROP(Polygon, ContainsItsCornersAndIsCounterClockwise, ()) {
  const Polygon polygon = test::random_polygon();
  RC_ASSERT(polygon.area() > 0);
  for (const Point corner : polygon.corners()) RC_ASSERT(polygon.contains(corner));
}

RC_GTEST_PROP(Polygon, IsTheSameInTheOtherSense, ()) {
  const Polygon polygon = test::random_polygon();
  std::vector<Point> corners = polygon.corners();
  std::reverse(corners.begin() + 1, corners.end());
  RC_ASSERT(*Polygon::make(corners) == polygon);
}

TEST(Polygon, LeavesOutALastCornerThatRepeatsTheFirst) {
  std::vector<Point> closed = kSquare;
  closed.push_back(closed.front());
  EXPECT_EQ(*Polygon::make(closed), *Polygon::make(kSquare));
}

TEST(Polygon, ContainsItsOutline) {
  const Polygon square = *Polygon::make(kSquare);
  EXPECT_TRUE(square.contains({1, 0}));
  EXPECT_TRUE(square.contains({2, 1.5}));
  EXPECT_TRUE(square.contains({1, 1}));
  EXPECT_FALSE(square.contains({2.001, 1}));
  EXPECT_FALSE(square.contains({-1, 0}));
}

TEST(Polygon, HasDistancesFromItsOutline) {
  const Polygon square = *Polygon::make(kSquare);
  EXPECT_EQ(distance_to_outline(square, {0.5, 1}), 0.5);
  EXPECT_EQ(distance_to_outline(square, {3, 1}), 1);
  EXPECT_EQ(farthest_distance(square, {0, 0}), std::sqrt(8));
  EXPECT_EQ(square.area(), 4);
  EXPECT_EQ(square.scaled(0.5).area(), 1);
}

TEST(Polygon, LeavesOutCornersThatRepeatTheOneBefore) {
  const std::vector<Point> repeated{{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2},
                                    {2, 2}, {0, 2}, {0, 0}, {0, 0}};
  EXPECT_EQ(*Polygon::make(repeated), *Polygon::make(kSquare));
}

RC_GTEST_PROP(Polygon, IsTheSameWithRepeatedCorners, ()) {
  const Polygon polygon = test::random_polygon();
  std::vector<Point> corners;
  for (const Point corner : polygon.corners()) {
    corners.insert(corners.end(), static_cast<std::size_t>(*rc::gen::inRange(1, 4)), corner);
  }
  if (*rc::gen::arbitrary<bool>()) corners.push_back(corners.front());
  RC_ASSERT(*Polygon::make(corners) == polygon);
}

TEST(Polygon, HasCornersOnItsEdges) {
  const Polygon square = *Polygon::make({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0.5}});
  EXPECT_EQ(square.corners().size(), 6);
  EXPECT_EQ(square.area(), 4);
}

std::vector<Point> regular_polygon(std::size_t corners) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(corners);
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

TEST(Polygon, HasHundredsOfCorners) {
  for (const std::size_t corners : {65U, 360U, 1000U, 4096U}) {
    const auto circle = Polygon::make(regular_polygon(corners));
    ASSERT_TRUE(circle) << circle.error().message;
    EXPECT_EQ(circle->corners().size(), corners);
    EXPECT_NEAR(circle->area(), kPi, 0.01);
  }
}

TEST(Polygon, CountsCornersAsTheyAreGiven) {
  const auto twice = Polygon::make({{0, 0}, {0, 0}, {1, 1}, {1, 1}, {1, 0}, {0, 1}});
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().message, HasSubstr("corners 1 and 5 cross"));
  EXPECT_EQ(twice.error().where, "corner 1");
  const auto back = Polygon::make({{0, 0}, {0, 0}, {2, 0}, {1, 0}, {1, 1}});
  ASSERT_FALSE(back);
  EXPECT_THAT(back.error().message, HasSubstr("the outline turns back on itself at corner 3"));
}

/// Edges that cross, found by comparing all of them.
bool crosses_itself(const std::vector<Point>& corners) {
  const std::size_t n = corners.size();
  const auto side = [](Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const Point a = corners[i], b = corners[(i + 1) % n], c = corners[j],
                  d = corners[(j + 1) % n];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
    }
  }
  return false;
}

RC_GTEST_PROP(Polygon, RefusesEdgesThatCross, ()) {
  std::vector<Point> corners;
  const int count = *rc::gen::inRange(3, 9);
  for (int i = 0; i < count; ++i) {
    corners.push_back({*rc::gen::inRange(-9, 10) / 1.0, *rc::gen::inRange(-9, 10) / 1.0});
  }
  const auto polygon = Polygon::make(corners);
  if (crosses_itself(corners)) RC_ASSERT(!polygon.has_value());
  if (!polygon) RC_ASSERT(!polygon.error().message.empty());
}

TEST(Polygon, RefusesWhatIsNotASimplePolygon) {
  const auto message = [](std::vector<Point> corners) {
    const auto polygon = Polygon::make(std::move(corners));
    return polygon ? std::string("none") : polygon.error().message;
  };
  EXPECT_THAT(message({{0, 0}, {1, 0}}), HasSubstr("3 to 4096 corners, not 2"));
  EXPECT_THAT(message(regular_polygon(4097)), HasSubstr("3 to 4096 corners, not 4097"));
  EXPECT_THAT(message({{0, 0}, {0, 0}, {1, 0}, {1, 0}, {0, 0}}),
              HasSubstr("corners, not 2 (5 with those that repeat the one before)"));
  EXPECT_THAT(message({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), HasSubstr("corners 1 and 3 cross"));
  EXPECT_THAT(message({{0, 0}, {2, 0}, {1, 0}}), HasSubstr("cross or touch"));
  EXPECT_THAT(message({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), HasSubstr("cross or touch"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message({{0, 0}, {1, nan}, {0, 1}}), HasSubstr("corner 2 has a coordinate"));
  EXPECT_THAT(message({{0, 0}, {1e7, 0}, {0, 1}}), HasSubstr("corner 2 has a coordinate"));
}

}  // namespace
}  // namespace wend
