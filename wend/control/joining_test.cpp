#include "wend/control/joining.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

Route along(const std::vector<Point>& points) { return Route(Path::along(points), {}); }

TEST(PlaceToJoin, IsTheNearestOne) {
  const auto place = place_to_join(along({{0, 0}, {9, 0}}), {4, 0.3, 0});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->leg, 0U);
  EXPECT_NEAR(place->along, 4, 1e-12);
  EXPECT_NEAR(place->distance, 0.3, 1e-12);
  EXPECT_FALSE(place_to_join(along({{0, 0}, {9, 0}}), {4, 1.5, 0})) << "too far away";
}

TEST(PlaceToJoin, IsOnTheLegWhereTheRobotIs) {
  const Route route(Path::through({{0, 0, 0}, {4, 0, 0}, {4, 0, kPi / 2}, {4, 4, kPi / 2}}), {});
  const auto place = place_to_join(route, {4.1, 3, kPi / 2});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->leg, 1U);
  EXPECT_NEAR(place->along, 3, 1e-12);
}

TEST(PlaceToJoin, OfTwoStrandsIsTheOneThatLeadsTheRobotsWay) {
  const Route there_and_back = along({{0, 0}, {9, 0}, {0, 0}});
  EXPECT_NEAR(place_to_join(there_and_back, {4, 0, 0})->along, 4, 1e-12);
  EXPECT_NEAR(place_to_join(there_and_back, {4, 0, kPi})->along, 14, 1e-12);
  const Route in_reverse(Path::through({{0, 0, 0}, {9, 0, 0}, {0, 0, 0}}), {});
  EXPECT_EQ(place_to_join(in_reverse, {4, 0, 0})->leg, 0U) << "both do: the first";
}

TEST(PlaceToJoin, IsTheStartWhereTheRobotIsThere) {
  const Route there_and_back = along({{0, 0}, {9, 0}, {0, 0}});
  for (const double heading : {0.0, 2.0, kPi}) {
    EXPECT_NEAR(place_to_join(there_and_back, {0.05, 0.02, heading})->along, 0.05, 1e-12);
  }
}

TEST(PlaceToJoin, CanBeReached) {
  const Route round_a_wall = along({{0, 0}, {9, 0}, {9, 0.4}, {0, 0.4}});
  const MapPose robot{4, 0.25, 0};
  EXPECT_NEAR(place_to_join(round_a_wall, robot, {.tie = 0.01})->along, 14.4, 1e-12);
  const FreeLine below = [](const MapPose&, MapPoint to) { return to.y < 0.3; };
  EXPECT_NEAR(place_to_join(round_a_wall, robot, {.tie = 0.01, .can_reach = below})->along, 4,
              1e-12);
  const FreeLine nowhere = [](const MapPose&, MapPoint) { return false; };
  EXPECT_FALSE(place_to_join(round_a_wall, robot, {.can_reach = nowhere}));
}

/// Brute force: no point of the route is nearer than the place by more than the tie.
TEST(PlaceToJoin, IsAsNearAsAnyPointButForTheTie) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<Point> points;
    for (int i = 0; i < 6; ++i) points.push_back({3 * random.uniform(), 3 * random.uniform()});
    const Route route = along(points);
    const MapPose robot{3 * random.uniform(), 3 * random.uniform(), 6 * random.uniform()};
    const MapPolyline& line = route.legs()[0].line;
    const double nearest = line.nearest(robot.point(), 0, line.length()).distance;
    const auto place = place_to_join(route, robot);
    ASSERT_EQ(place.has_value(), nearest <= 1);
    if (!place) continue;
    EXPECT_LE(place->distance, nearest + 0.15 + 1e-12);
    EXPECT_NEAR(distance(line.at(place->along).point(), robot.point()), place->distance, 1e-9);
  }
}

TEST(SameRoute, IsTheSameButForRounding) {
  const Route route = along({{0, 0}, {9, 0}, {9, 4}});
  EXPECT_TRUE(same_route(route, along({{0, 0}, {9, 1e-9}, {9, 4}})));
  EXPECT_FALSE(same_route(route, along({{0, 0}, {9, 0.01}, {9, 4}})));
  EXPECT_FALSE(same_route(route, along({{0, 0}, {9, 0}})));
  EXPECT_FALSE(same_route(Route(Path::through({{0, 0, 0}, {9, 0, 0}}), {}),
                          Route(Path::through({{0, 0, 0}, {9, 0, 0}, {9, 0, 1}}), {})));
}

}  // namespace
}  // namespace wend
