#include "wend/control/given_route.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path.hpp"

namespace wend {
namespace {

using Poses = std::vector<MapPose>;

/// A line from the origin to (x, y) with one heading, sampled each 0.1 m.
Poses line_to(double x, double y, double heading) {
  const int count = static_cast<int>(std::ceil(std::hypot(x, y) / 0.1));
  Poses poses;
  for (int i = 0; i <= count; ++i) poses.push_back({x * i / count, y * i / count, heading});
  return poses;
}

TEST(GivenRoute, DrivesAStraightLineInReverseAtAnyHeading) {
  for (const double heading : {0.0, 1e-9, 0.05, kPi / 2, -2.0}) {
    SCOPED_TRACE(heading);
    const Poses poses = line_to(-2 * std::cos(heading), -2 * std::sin(heading), heading);
    EXPECT_TRUE(headings_count(poses));
    const Route route = given_route(poses).value();
    ASSERT_EQ(route.legs().size(), 1U);
    EXPECT_TRUE(route.legs()[0].reverse);
    EXPECT_NEAR(normalized_angle(route.start().heading - heading), 0, 1e-9);
    EXPECT_EQ(route.final_heading(), heading);
  }
}

TEST(GivenRoute, DrivesALineAheadWhoseHeadingsAreFilledIn) {
  Poses bent = line_to(-2, 0, 0);
  bent.push_back({-2, 1, 0});
  Poses aside = line_to(0, 2, 0);
  Poses to_goal = line_to(-2, 0, 0);
  to_goal.back().heading = kPi;
  Poses from_robot = line_to(-2, 0, 0);
  from_robot.front().heading = kPi;
  for (const Poses& poses : {bent, aside, to_goal, from_robot}) {
    EXPECT_FALSE(headings_count(poses));
    const Route route = given_route(poses).value();
    ASSERT_EQ(route.legs().size(), 1U);
    EXPECT_FALSE(route.legs()[0].reverse);
    EXPECT_EQ(route.final_heading(), poses.back().heading);
  }
}

/// Where it does not matter to the direction: the same line, ahead.
TEST(GivenRoute, DrivesALineAheadThatFacesAhead) {
  for (const double last : {0.0, 1.0}) {
    Poses poses = line_to(2, 0, 0);
    poses.back().heading = last;
    const Route route = given_route(poses).value();
    ASSERT_EQ(route.legs().size(), 1U);
    EXPECT_FALSE(route.legs()[0].reverse);
    EXPECT_FALSE(route.legs()[0].turn_first);
  }
}

TEST(GivenRoute, HasALegForEachReversalAndEachTurnInPlace) {
  const double up = kPi / 2;
  const Route reversals =
      given_route(
          Poses{{0, 0, up}, {0, 1, up}, {0, 2, up}, {0, 1.5, up}, {0, 1, up}, {0, 1.5, up + 1e-3}})
          .value();
  ASSERT_EQ(reversals.legs().size(), 3U);
  EXPECT_TRUE(reversals.legs()[1].reverse);
  for (const RouteLeg& leg : reversals.legs()) EXPECT_FALSE(leg.turn_first);

  const Route turns = given_route(Poses{{0, 0, 1},
                                        {0, 0, 0},
                                        {1, 0, 0},
                                        {1, 0, 0.01},
                                        {2, 0.01, 0.01},
                                        {2, 0.01, 0.01},
                                        {3, 0.02, 0.01},
                                        {3, 0.02, 1}})
                          .value();
  ASSERT_EQ(turns.legs().size(), 2U) << "a pose that comes twice does not turn";
  EXPECT_TRUE(turns.legs()[0].turn_first);
  EXPECT_TRUE(turns.legs()[1].turn_first);
  EXPECT_EQ(turns.final_heading(), 1);
}

TEST(GivenRoute, StopsWhereALineComesBack) {
  const Route route = given_route(Poses{{0, 0, 0}, {1, 0.2, 0}, {0.1, 0.1, 0}}).value();
  ASSERT_EQ(route.legs().size(), 2U);
  EXPECT_TRUE(route.legs()[1].turn_first);
  EXPECT_EQ(given_route(Poses{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}).value().legs().size(), 1U);
}

TEST(GivenRoute, OfPosesInOnePlaceEndsWithTheLastHeading) {
  for (const Poses& poses : {Poses{{1, 2, 3}}, Poses{{1, 2, 0}, {1, 2, 3}}, Poses(5, {1, 2, 3})}) {
    const Route route = given_route(poses).value();
    ASSERT_EQ(route.legs().size(), 1U);
    EXPECT_EQ(route.length(), 0);
    EXPECT_EQ(route.end(), (MapPose{1, 2, 3}));
  }
}

TEST(GivenRoute, RefusesWhatCannotBeDriven) {
  EXPECT_FALSE(given_route({}));
  for (const double number : {std::numeric_limits<double>::quiet_NaN(),
                              -std::numeric_limits<double>::infinity(), 1e300}) {
    const auto route = given_route(Poses{{0, 0, 0}, {1, number, 0}});
    ASSERT_FALSE(route);
    EXPECT_EQ(route.error().where, "pose 1");
  }
}

/// Random drives of arcs and turns in place, sampled: the route has their gears and their length.
TEST(GivenRoute, KnowsTheGearsOfRandomDrives) {
  Random random(5);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    Poses poses{{0, 0, random.uniform()}};
    std::vector<bool> gears;
    double length = 0;
    const int pieces = static_cast<int>(random.between(1, 6));
    for (int piece = 0; piece < pieces; ++piece) {
      MapPose here = poses.back();
      const bool back = random.chance(0.5);
      const bool turns = piece > 0 && random.chance(0.3);
      if (turns) {
        here.heading += 0.2 + random.uniform();
        poses.push_back(here);
      }
      const MapArc arc{here, (back ? -1 : 1) * (0.3 + random.uniform()), 2 * random.uniform() - 1};
      constexpr int kSamples = 8;
      for (int i = 1; i <= kSamples; ++i) poses.push_back(pose_on(arc, arc.length * i / kSamples));
      length += std::abs(arc.length);
      if (gears.empty() || gears.back() != back || turns) gears.push_back(back);
    }
    const Route route = given_route(poses).value();
    ASSERT_EQ(route.legs().size(), gears.size());
    for (std::size_t i = 0; i < gears.size(); ++i) {
      EXPECT_EQ(route.legs()[i].reverse, gears[i]);
    }
    EXPECT_NEAR(route.length(), length, 0.01 * length);
  }
}

}  // namespace
}  // namespace wend
