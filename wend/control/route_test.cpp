#include "wend/control/route.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr double kRounding = 1e-12;

void expect_near(const MapPose& a, const MapPose& b) {
  EXPECT_NEAR(a.x, b.x, kRounding);
  EXPECT_NEAR(a.y, b.y, kRounding);
  EXPECT_NEAR(normalized_angle(a.heading - b.heading), 0, kRounding);
}

TEST(Route, OfCellsIsOneLegInMetres) {
  const Frame frame{.resolution = 0.1, .origin = {1, 2, kPi / 2}};
  const Route route(Path({{0, 0}, {1, 0}, {1, 1}}), frame);
  ASSERT_EQ(route.legs().size(), 1U);
  EXPECT_FALSE(route.legs()[0].reverse);
  EXPECT_NEAR(route.length(), 0.2, kRounding);
  EXPECT_EQ(route.final_heading(), std::nullopt);
  expect_near(route.start(), {0.95, 2.05, kPi / 2});
  expect_near(route.end(), {0.85, 2.15, kPi});
}

TEST(Route, OfLegsIsThatOfThePathWithTheseLegs) {
  const Frame frame{.resolution = 0.5, .origin = {1, 2, 0}};
  const Route route(Path::through({{1, 1, 0}, {4, 1, 0}, {2, 1, 0}}), frame);
  ASSERT_EQ(route.legs().size(), 2U);
  const Route again(route.legs(), route.final_heading());
  expect_near(again.start(), route.start());
  expect_near(again.end(), route.end());
  EXPECT_EQ(again.final_heading(), route.final_heading());
  EXPECT_NEAR(again.length(), 2.5, kRounding);
}

TEST(Route, OfALegInReverseHasTheRobotTurnedRound) {
  const Route route({RouteLeg{MapPolyline({{0, 0}, {2, 0}}), true}});
  expect_near(route.start(), {0, 0, kPi});
  expect_near(route.end(), {2, 0, kPi});
  EXPECT_EQ(route.final_heading(), std::nullopt);
}

TEST(Route, OfASinglePointHasNoLength) {
  for (const Path& path : {Path(std::vector<Cell>{{3, 4}}), Path::along({{3.5, 4.5}}),
                           Path::through({{3.5, 4.5, 0}})}) {
    const Route route(path, {});
    ASSERT_EQ(route.legs().size(), 1U);
    EXPECT_EQ(route.length(), 0);
    EXPECT_EQ(route.start(), (MapPose{3.5, 4.5, 0}));
    EXPECT_EQ(route.end(), route.start());
  }
}

TEST(Route, OfALapComesBack) {
  const std::vector<Point> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Route route(Path::along(square), {}, true);
  EXPECT_EQ(route.length(), 16);
  expect_near(route.start(), {0, 0, 0});
  expect_near(route.end(), {0, 0, -kPi / 2});
  EXPECT_EQ(Route(Path::along(square), {}).length(), 12);
}

/// Ahead 2, a quarter circle to the left in reverse, ahead 1, with headings all along.
Path three_legs() {
  return Path::through({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, -kPi / 2}, {1, 0, -kPi / 2}});
}

TEST(Route, HasALegForEachStretchBetweenReversals) {
  const Route route(three_legs(), {.resolution = 0.5});
  ASSERT_EQ(route.legs().size(), 3U);
  EXPECT_FALSE(route.legs()[0].reverse);
  EXPECT_TRUE(route.legs()[1].reverse);
  EXPECT_FALSE(route.legs()[2].reverse);
  EXPECT_NEAR(route.legs()[0].line.length(), 1, kRounding);
  EXPECT_NEAR(route.legs()[1].line.length(), kPi / 4, 0.01);
  EXPECT_NEAR(route.legs()[2].line.length(), 0.5, kRounding);
  expect_near(route.start(), {0, 0, 0});
  expect_near(route.end(), {0.5, 0, -kPi / 2});
  EXPECT_EQ(route.final_heading(), -kPi / 2);
}

TEST(Route, JoinsItsLegs) {
  const Route route(three_legs(), {});
  for (std::size_t i = 1; i < route.legs().size(); ++i) {
    const MapPoint before = route.legs()[i - 1].line.points().back();
    EXPECT_NEAR(distance(before, route.legs()[i].line.points().front()), 0, kRounding);
  }
}

TEST(Route, FollowsArcsWithinAHundredthOfACell) {
  const Route route(Path::through({{0, 0, 0}, {10, 10, kPi / 2}}), {});
  const auto points = route.legs()[0].line.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR(distance(points[i], {0, 10}), 10, kRounding);
    const MapPoint middle{(points[i].x + points[i - 1].x) / 2, (points[i].y + points[i - 1].y) / 2};
    EXPECT_GE(distance(middle, {0, 10}), 10 - 0.01);
  }
}

TEST(Route, EndsInReverseAsItsLastPoseSays) {
  const Route route(Path::through({{3, 0, 0}, {0, 0, 0}}), {});
  ASSERT_EQ(route.legs().size(), 1U);
  EXPECT_TRUE(route.legs()[0].reverse);
  expect_near(route.start(), {3, 0, 0});
  expect_near(route.end(), {0, 0, 0});
}

TEST(Route, ComesBackFromADriveAhead) {
  const Route ahead(Path::through({{0, 0, 0}, {4, 4, kPi / 2}}), {}, true);
  ASSERT_EQ(ahead.legs().size(), 1U);
  EXPECT_EQ(ahead.final_heading(), std::nullopt);
  expect_near(ahead.end(), {0, 0, -3 * kPi / 4});

  const Route back(Path::through({{4, 0, 0}, {0, 0, 0}}), {}, true);
  ASSERT_EQ(back.legs().size(), 2U);
  EXPECT_TRUE(back.legs()[0].reverse);
  EXPECT_FALSE(back.legs()[1].reverse);
  expect_near(back.end(), {4, 0, 0});
}

TEST(Route, BeginsALegWhereThePathTurnsInPlace) {
  const Route route(Path::through({{0, 0, 1},
                                   {0, 0, 0},
                                   {3, 0, 0},
                                   {3, 0, kPi / 2},
                                   {3, 2, kPi / 2},
                                   {3, 2, kPi / 2 + 0.1},
                                   {2.9, 3, kPi / 2 + 0.1},
                                   {2.9, 3, 0}}),
                    {});
  ASSERT_EQ(route.legs().size(), 3U) << "at every turn, however small; the last is the goal's";
  EXPECT_TRUE(route.legs()[0].turn_first) << "the path begins with a turn";
  EXPECT_TRUE(route.legs()[1].turn_first);
  EXPECT_TRUE(route.legs()[2].turn_first);
  EXPECT_NEAR(route.legs()[0].line.length(), 3, kRounding);
  expect_near(route.start(), {0, 0, 1});
  EXPECT_EQ(route.final_heading(), 0);
}

TEST(Route, KnowsStepsToTheSide) {
  EXPECT_FALSE(first_step_aside(Path({{0, 0}, {1, 1}})));
  EXPECT_FALSE(first_step_aside(Path::through({{0, 0, 0}, {2, 0.1, 0}, {2, 0.1, 1}})))
      << "nearly ahead";
  const auto aside = first_step_aside(Path::through({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}}));
  ASSERT_TRUE(aside);
  EXPECT_EQ(*aside, (Pose{2, 0, 0}));
}

TEST(Route, IgnoresPosesOnTopOfEachOther) {
  const Route route(Path::through({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {1, 0, 0}}), {});
  ASSERT_EQ(route.legs().size(), 2U);
  EXPECT_NEAR(route.length(), 3, kRounding);
}

TEST(Route, HasNoPiecesThatAreRounding) {
  constexpr double kTiny = 4e-16;
  const Route route(
      Path::through({{0, 0, 0}, {2, 0, 0}, {2 + kTiny, kTiny, 1e-3}, {2, kTiny, 0}, {3, 0, 0}}),
      {.resolution = 0.5});
  ASSERT_EQ(route.legs().size(), 2U) << "it turns there, and back";
  for (const RouteLeg& leg : route.legs()) EXPECT_EQ(leg.line.points().size(), 2U);
  const Route of_lines(Path::along({{0, 0}, {1, 0}, {1 + kTiny, 0}, {1, kTiny}}), {});
  EXPECT_EQ(of_lines.legs()[0].line.points().size(), 2U);
  const Route of_legs({RouteLeg{MapPolyline({{0, 0}, {1, 0}, {1, kTiny}})}});
  EXPECT_EQ(of_legs.legs()[0].line.points().size(), 2U);
  EXPECT_EQ(of_legs.end().y, kTiny) << "the last point stays";
}

TEST(Route, KeepsALineOfManyTinyPieces) {
  std::vector<Point> points;
  for (int i = 0; i <= 10000; ++i) points.push_back({i * 1e-7, 0});
  EXPECT_NEAR(Route(Path::along(points), {}).length(), 1e-3, 1e-9);
}

TEST(Route, OfWhatIsNotFiniteIsNotValid) {
  for (const double number : {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity(), 1e300, -1e9}) {
    EXPECT_FALSE(Route(Path::along({{0, 0}, {number, 0}}), {}).valid());
    EXPECT_FALSE(Route(Path::through({{0, number, 0}, {1, 0, 0}}), {}).valid());
    EXPECT_FALSE(Route({RouteLeg{MapPolyline({{number, 0}})}}).valid());
  }
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Route nowhere(Path::through({{0, 0, 0}, {1, 0, kNan}}), {});
  EXPECT_FALSE(nowhere.valid());
  EXPECT_EQ(nowhere.length(), 0);
  EXPECT_EQ(nowhere.legs().size(), 1U);
  EXPECT_FALSE(Route({RouteLeg{MapPolyline({{0, 0}})}}, kNan).valid());
  EXPECT_FALSE(Route(Path::through({{0, 0, 0}, {1, 0, 1e29}}), {}).valid());
  EXPECT_TRUE(Route(Path::along({{0, 0}, {1, 0}}), {}).valid());
}

TEST(Route, OfArcsThatCrossThePlanetStaysSmall) {
  std::vector<Pose> poses;
  for (int i = 0; i < 300; ++i) poses.push_back({i % 2 * 9e7, i * 1e3, 1.5 * (i % 3)});
  const Route route(Path::through(poses), {});
  EXPECT_TRUE(route.valid());
  std::size_t points = 0;
  for (const RouteLeg& leg : route.legs()) points += leg.line.points().size();
  EXPECT_LE(points, Route::kMostChords + 6 * poses.size());
  EXPECT_GT(points, poses.size());
}

}  // namespace
}  // namespace wend
