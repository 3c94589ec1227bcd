// The guard of the follower, against the robot's shape put down every centimetre of the way.

#include "wend_ros/path_guard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/path/path.hpp"

namespace wend_ros {
namespace {

constexpr double kResolution = 0.1;
constexpr wend::Frame kFrame{
    .resolution = kResolution, .origin = {-3, 2, 0}, .y_up = true, .metric = true};

/// 100 x 60 cells, from (-3, 2) to (7, 8) m, with these obstacles, for a robot.
wend::FreeSpace space_with(const std::vector<wend::Cell>& obstacles,
                           const wend::Footprint& robot = wend::Footprint::disc(0.3)) {
  wend::Grid<wend::CellState> cells(100, 60, wend::CellState::free);
  for (const wend::Cell cell : obstacles) cells[cell] = wend::CellState::occupied;
  return *wend::make_free_space(*wend::make_grid_map(cells, kFrame), {.footprint = robot});
}

/// From (-2, 5) to (6, 5), along the middle of the map.
wend::Route straight() { return wend::Route(wend::Path::along({{-2, 5}, {6, 5}}), wend::Frame{}); }

/// Tests 1 + 0.5 m: half a second's way to stop from 1 m/s, and half a metre.
PathGuard guard(double escape = 0) {
  return {{.speed = 1, .acceleration = 0.5},
          1e-9,
          0.3,
          {.look_ahead = 0.5, .join_margin = 0.1, .escape = escape}};
}

bool blocked(const wend::FreeSpace& space, double along) {
  return guard().why_blocked({space}, straight(), {0, along}).has_value();
}

TEST(PathGuard, LooksAsFarAsTheRobotNeedsToStopAndFarther) {
  EXPECT_NEAR(guard().reach(), 1.5, 1e-6);
  // The obstacle begins at x = 2; the disc touches it from x = 1.7 on, 3.7 m along.
  const wend::FreeSpace space = space_with({{50, 30}});
  EXPECT_FALSE(blocked(space, 2.19)) << "1.51 m ahead";
  EXPECT_TRUE(blocked(space, 2.21)) << "1.49 m ahead";
  EXPECT_TRUE(blocked(space, 4));
  EXPECT_FALSE(blocked(space, 4.45)) << "it is behind: the disc leaves it at 4.4 m";
}

TEST(PathGuard, SaysWhereAndWhy) {
  const wend::FreeSpace space = space_with({{50, 30}});
  const auto fault = guard().why_blocked({space}, straight(), {0, 3});
  ASSERT_TRUE(fault);
  EXPECT_EQ(*fault,
            "blocked 0.7 m ahead, at (1.7, 5): the path comes closer to an obstacle than the "
            "robot's radius");
}

TEST(PathGuard, KnowsWhereTheFrameOfTheRouteLies) {
  const wend::FreeSpace space = space_with({{50, 30}});  // at (2, 5) m
  const wend::Route up(wend::Path::along({{0, 0}, {0, 4}}), wend::Frame{});
  // Turned by -90 degrees, the way up is one along +x from (1, 5).
  const wend::MapPose lies{1, 5, -wend::kPi / 2};
  EXPECT_TRUE(guard().why_blocked({space, lies}, up, {0, 0}));
  EXPECT_FALSE(guard().why_blocked({space, {1, 3, -wend::kPi / 2}}, up, {0, 0}));
}

TEST(PathGuard, SweepsAPolygonAsItIsDriven) {
  // 1.2 m behind the base point, 0.2 m ahead.
  const auto robot = *wend::parse_footprint("[[0.2, 0.2], [-1.2, 0.2], [-1.2, -0.2], [0.2, -0.2]]");
  const wend::FreeSpace space = space_with({{50, 30}}, robot);  // from x = 2 on
  const wend::Path back = wend::Path::through({{0, 5, wend::kPi}, {1.5, 5, wend::kPi}});
  const wend::Path ahead = wend::Path::through({{0, 5, 0}, {1.5, 5, 0}});
  EXPECT_TRUE(guard().why_blocked({space}, wend::Route(back, wend::Frame{}), {0, 0}))
      << "in reverse its long rear leads";
  EXPECT_FALSE(guard().why_blocked({space}, wend::Route(ahead, wend::Frame{}), {0, 0}));
  const wend::Path turn = wend::Path::through({{0.9, 5, 0}, {1, 5, 0}, {1, 5, wend::kPi}});
  EXPECT_TRUE(guard().why_blocked({space}, wend::Route(turn, wend::Frame{}), {0, 0}))
      << "where it turns at the end, its rear comes round";
}

/// Puts the disc down each centimetre, on lines between random points.
TEST(PathGuard, IsWhatADiscSaysThatIsPutDownEachCentimetre) {
  std::mt19937 random(3);
  const auto draw = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  int free = 0;
  int hits = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<wend::Cell> obstacles;
    for (int i = 0; i < 12; ++i) {
      obstacles.push_back({static_cast<int>(draw(0, 100)), static_cast<int>(draw(0, 60))});
    }
    const wend::FreeSpace space = space_with(obstacles);
    std::vector<wend::Point> points;
    for (int i = 0; i < 4; ++i) points.push_back({draw(-2.5, 6.5), draw(2.5, 7.5)});
    const wend::Route route(wend::Path::along(points), wend::Frame{});
    const wend::MapPolyline& line = route.legs()[0].line;
    const double from = draw(0, line.length());
    const double to = std::min(line.length(), from + 1.5);
    double nearest = 1e9;  // the least distance to an obstacle, m
    for (double along = from; along < to; along += 0.01) {
      const wend::MapPose at = line.at(along);
      for (const wend::Cell cell : obstacles) {
        const double x = kFrame.origin.x + kResolution * cell.x;
        const double y = kFrame.origin.y + kResolution * cell.y;
        nearest = std::min(nearest, std::hypot(std::max({x - at.x, at.x - x - kResolution, 0.0}),
                                               std::max({y - at.y, at.y - y - kResolution, 0.0})));
      }
      nearest = std::min({nearest, at.x + 3, 7 - at.x, at.y - 2, 8 - at.y});  // the map's edge
    }
    const bool is_blocked = guard().why_blocked({space}, route, {0, from}).has_value();
    ASSERT_TRUE(nearest >= 0.3 || is_blocked) << round;
    ASSERT_TRUE(nearest <= 0.31 || !is_blocked) << round;
    (is_blocked ? hits : free) += 1;
  }
  EXPECT_GT(free, 100);
  EXPECT_GT(hits, 100);
}

TEST(PathGuard, LetsARobotLeaveAnObstacleThatItOverlapsAndNoFarther) {
  const wend::FreeSpace space = space_with({{9, 30}});  // ends at x = -2, where the route begins
  EXPECT_TRUE(guard().why_blocked({space}, straight(), {0, 0.1})) << "no escape is allowed";
  EXPECT_FALSE(guard(0.25).why_blocked({space}, straight(), {0, 0.1}));
  EXPECT_TRUE(guard(0.1).why_blocked({space}, straight(), {0, 0.1})) << "it needs 0.2 m";
  const wend::Route towards(wend::Path::along({{-1.8, 5}, {-2.5, 5}}), wend::Frame{});
  EXPECT_TRUE(guard(0.25).why_blocked({space}, towards, {0, 0})) << "it would come nearer";
  const wend::FreeSpace more = space_with({{9, 30}, {22, 30}});  // from x = -0.8 on
  EXPECT_TRUE(guard(0.25).why_blocked({more}, straight(), {0, 0.1})) << "there is another one";
}

TEST(PathGuard, SweepsTheTurnBeforeALeg) {
  const auto robot = *wend::parse_footprint("[[0.8, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.8, -0.2]]");
  const wend::FreeSpace space =
      space_with({{10, 36}}, robot);  // beside the beginning, 0.6 m to the left
  EXPECT_FALSE(guard().why_blocked({space}, straight(), {0, 0}));
  EXPECT_FALSE(guard().why_blocked({space}, straight(), {0, 0, wend::MapPose{-2, 5, 0.05}}));
  EXPECT_TRUE(guard().why_blocked({space}, straight(), {0, 0, wend::MapPose{-2, 5, 2.5}}));
  EXPECT_FALSE(guard().why_blocked({space}, straight(), {0, 0, wend::MapPose{-2, 5, -2.5}}));
  EXPECT_FALSE(guard().why_blocked({space}, straight(), {0, 1, wend::MapPose{-1, 5, 2.5}}));
}

TEST(PathGuard, LetsAPolygonLeaveOnlyWhereItNeverOverlapsMore) {
  const auto robot = *wend::parse_footprint("[[0.8, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.8, -0.2]]");
  const wend::FreeSpace behind = space_with({{8, 30}}, robot);  // its rear overlaps 0.1 m
  EXPECT_TRUE(guard().why_blocked({behind}, straight(), {0, 0}));
  EXPECT_FALSE(guard(0.25).why_blocked({behind}, straight(), {0, 0}));
  const wend::FreeSpace ahead = space_with({{17, 30}}, robot);
  EXPECT_TRUE(guard(0.25).why_blocked({ahead}, straight(), {0, 0}));
}

TEST(CanReach, IsNotAcrossAWall) {
  std::vector<wend::Cell> wall;
  for (int y = 0; y < 60; ++y) wall.push_back({50, y});  // from x = 2 to 2.1
  const wend::FreeSpace space = space_with(wall);
  EXPECT_FALSE(guard().can_reach({space}, {1.5, 5}, {2.6, 5}));
  EXPECT_TRUE(guard().can_reach({space}, {1.5, 5}, {0.5, 6}));
  EXPECT_TRUE(guard().can_reach({space}, {1.75, 5}, {1.75, 6})) << "a little nearer than on a path";
  EXPECT_FALSE(guard().can_reach({space}, {1.85, 5}, {1.85, 6}));
}

TEST(SweptFootprint, IsSmallerThanTheRobotByNoMoreThanTheMargin) {
  const wend::Footprint disc = swept_footprint(wend::Footprint::disc(0.3), 0.02);
  EXPECT_NEAR(disc.circumscribed_radius(), 0.28, 1e-12);
  EXPECT_EQ(swept_footprint(wend::Footprint::disc(0.01), 0.02), wend::Footprint());
  const auto robot = *wend::parse_footprint("[[3.7, 0.9], [-0.8, 0.9], [-0.8, -0.9], [3.7, -0.9]]");
  const wend::Footprint swept = swept_footprint(robot, 0.02);
  ASSERT_NE(swept.outline(), nullptr);
  for (const wend::Point corner : swept.outline()->corners()) {
    EXPECT_TRUE(robot.outline()->contains(corner));
    double nearest = 1e9;
    for (const wend::Point old : robot.outline()->corners()) {
      nearest = std::min(nearest, std::hypot(corner.x - old.x, corner.y - old.y));
    }
    EXPECT_NEAR(nearest, 0.02, 1e-9);
  }
}

}  // namespace
}  // namespace wend_ros
