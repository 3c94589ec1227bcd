// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/way_ahead.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "wend/map/occupancy.hpp"
#include "wend_nav2/costmaps_test.hpp"

namespace wend_nav2 {
namespace {

using test::Costmap;
using test::empty_costmap;

wend::FreeSpace space_of(const Costmap& map, double radius) {
  const auto made = wend::map_from_costmap(map.costs, map.layout.width, map.layout.height,
                                           map.layout.frame(), {.inscribed_blocked = false});
  return *wend::make_free_space(
      *made, {.footprint = wend::Footprint::disc(radius), .unknown = wend::UnknownPolicy::free});
}

RC_GTEST_PROP(FrameChange, KeepsTheRobotAndDistances, ()) {
  const auto number = [](int most) { return *rc::gen::inRange(-most, most) / 100.0; };
  const wend::MapPose here{number(1000), number(1000), number(314)};
  const wend::MapPose there{number(1000), number(1000), number(314)};
  const FrameChange change(here, there);
  const wend::MapPose moved = change(here);
  RC_ASSERT(distance(moved.point(), there.point()) < 1e-9);
  RC_ASSERT(std::abs(moved.heading - there.heading) < 1e-9);
  const wend::MapPoint a{number(1000), number(1000)};
  const wend::MapPoint b{number(1000), number(1000)};
  RC_ASSERT(std::abs(distance(change(a), change(b)) - distance(a, b)) < 1e-9);
  // What lies ahead of the robot lies ahead of it.
  const wend::MapPoint ahead{here.x + std::cos(here.heading), here.y + std::sin(here.heading)};
  const wend::MapPoint seen = change(ahead);
  RC_ASSERT(std::abs(seen.x - there.x - std::cos(there.heading)) < 1e-9);
  RC_ASSERT(std::abs(seen.y - there.y - std::sin(there.heading)) < 1e-9);
}

TEST(WayAhead, SeesAWallOnlyAsFarAsItLooks) {
  Costmap map = empty_costmap(60, 40);
  for (int y = 0; y < 40; ++y) map.at(30, y) = 254;  // from 3.0 to 3.1 m
  const wend::FreeSpace space = space_of(map, 0.2);
  const wend::RouteLeg leg{wend::MapPolyline({{1, 2}, {2, 2}, {5, 2}})};
  const FrameChange same({1, 2, 0}, {1, 2, 0});
  EXPECT_TRUE(is_free_ahead(leg, 0, 1.8, same, space));
  EXPECT_FALSE(is_free_ahead(leg, 0, 2.2, same, space));
  EXPECT_FALSE(is_free_ahead(leg, 0.5, 9, same, space));
  EXPECT_TRUE(is_free_ahead(leg, 2.4, 9, same, space)) << "it lies behind";
  // In the costmap the same way leads up.
  const FrameChange turned({1, 2, 0}, {1, 1, 1.5707963267948966});
  EXPECT_TRUE(is_free_ahead(leg, 0, 9, turned, space));
}

TEST(WayAhead, APassageThatTheRobotFitsInIsFree) {
  Costmap map = empty_costmap(60, 40);
  for (int x = 0; x < 60; ++x) map.at(x, 17) = map.at(x, 22) = 254;  // 0.4 m between
  const wend::RouteLeg leg{wend::MapPolyline({{1, 2}, {5, 2}})};
  const FrameChange same({1, 2, 0}, {1, 2, 0});
  EXPECT_TRUE(is_free_ahead(leg, 0, 9, same, space_of(map, 0.2)));
  EXPECT_FALSE(is_free_ahead(leg, 0, 9, same, space_of(map, 0.3)));
  const wend::RouteLeg point{wend::MapPolyline({{1, 2}})};
  EXPECT_TRUE(is_free_ahead(point, 0, 9, same, space_of(map, 0.2)));
}

}  // namespace
}  // namespace wend_nav2
