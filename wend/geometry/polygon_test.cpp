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

TEST(Polygon, RefusesWhatIsNotASimplePolygon) {
  const auto message = [](std::vector<Point> corners) {
    const auto polygon = Polygon::make(std::move(corners));
    return polygon ? std::string("none") : polygon.error().message;
  };
  EXPECT_THAT(message({{0, 0}, {1, 0}}), HasSubstr("3 to 64 corners, not 2"));
  std::vector<Point> round;
  for (int i = 0; i < 65; ++i) round.push_back({std::cos(0.09 * i), std::sin(0.09 * i)});
  EXPECT_THAT(message(round), HasSubstr("3 to 64 corners, not 65"));
  EXPECT_THAT(message({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
              HasSubstr("corner 2 and the corner after"));
  EXPECT_THAT(message({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), HasSubstr("corners 1 and 3 cross"));
  EXPECT_THAT(message({{0, 0}, {2, 0}, {1, 0}}), HasSubstr("cross or touch"));
  EXPECT_THAT(message({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), HasSubstr("cross or touch"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message({{0, 0}, {1, nan}, {0, 1}}), HasSubstr("corner 2 has a coordinate"));
  EXPECT_THAT(message({{0, 0}, {1e7, 0}, {0, 1}}), HasSubstr("corner 2 has a coordinate"));
}

}  // namespace
}  // namespace wend
