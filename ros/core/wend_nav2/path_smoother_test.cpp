// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_smoother.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "wend_nav2/costmaps_test.hpp"
#include "wend_nav2/path_length_test.hpp"
#include "wend_nav2/path_planner.hpp"

namespace wend_nav2 {
namespace {

using Poses = PathSmoother::Poses;
using test::Costmap;
using test::costmap_of;
using test::empty_costmap;
using test::middle_of;

const RobotShape kSmallDisc{wend::Footprint::disc(0.1), true};

bool never() { return false; }

wend::Expected<PathSmoother::Result, Failure> smooth(const Costmap& map, const Poses& path,
                                                     const std::string& smoother = "gradient") {
  PathSmoother made;
  made.set(*smoother_settings_from(smoother, {}));
  made.costmap().read(map.layout, map.costs);
  return made.smooth(path, kSmallDisc, never);
}

/// Poses in the middles of cells from one to the next, each facing the next.
Poses path_through(const Costmap& map, const std::vector<wend::Cell>& corners) {
  Poses path{middle_of(map, corners.front().x, corners.front().y)};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const wend::Cell a = corners[i - 1];
    const wend::Cell b = corners[i];
    const int steps = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
    for (int n = 1; n <= steps; ++n) {
      path.push_back(middle_of(map, a.x + (b.x - a.x) * n / steps, a.y + (b.y - a.y) * n / steps));
    }
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    path[i].heading = std::atan2(path[i + 1].y - path[i].y, path[i + 1].x - path[i].x);
  }
  path.back().heading = path[path.size() - 2].heading;
  return path;
}

RC_GTEST_PROP(PathSmoother, KeepsTheEndsAndStaysFree, ()) {
  const int width = *rc::gen::inRange(4, 16);
  const int height = *rc::gen::inRange(4, 16);
  Costmap map = empty_costmap(width, height);
  for (auto& cost : map.costs) {
    const int kind = *rc::gen::inRange(0, 5);
    cost = kind == 0 ? 254 : 0;
  }
  map.at(0, 0) = 0;
  map.at(width - 1, height - 1) = 0;
  PathPlanner planner;
  planner.set(*settings_from("astar", {{"smooth", "false"}, {"tolerance", "0"}}));
  planner.costmap().read(map.layout, map.costs);
  const auto planned = planner.plan(
      {middle_of(map, 0, 0, 2), middle_of(map, width - 1, height - 1, -1), kSmallDisc}, {});
  if (!planned) return;
  const auto name = *rc::gen::elementOf(std::vector<std::string>{"gradient", "curvature"});
  const auto smoothed = smooth(map, *planned, name);
  RC_ASSERT(smoothed.has_value());
  RC_ASSERT(smoothed->complete);
  RC_ASSERT(smoothed->poses.front() == planned->front());
  RC_ASSERT(smoothed->poses.back() == planned->back());
  RC_ASSERT(test::path_length(smoothed->poses) <= test::path_length(*planned) + 1e-6);
  for (const wend::MapPose& pose : smoothed->poses) {
    const auto cost = map.at(static_cast<int>(std::floor(pose.x / 0.1 + 1e-9)),
                             static_cast<int>(std::floor(pose.y / 0.1 + 1e-9)));
    const auto below = map.at(static_cast<int>(std::floor(pose.x / 0.1 - 1e-9)),
                              static_cast<int>(std::floor(pose.y / 0.1 - 1e-9)));
    RC_ASSERT(cost < 253 || below < 253);
  }
}

TEST(PathSmoother, RoundsACorner) {
  const Costmap map = empty_costmap(20, 20);
  const Poses path = path_through(map, {{2, 2}, {15, 2}, {15, 15}});
  const auto smoothed = smooth(map, path);
  ASSERT_TRUE(smoothed);
  EXPECT_LT(test::path_length(smoothed->poses), test::path_length(path) - 0.05);
  for (std::size_t i = 0; i + 2 < smoothed->poses.size(); ++i) {
    const double turn = smoothed->poses[i + 1].heading - smoothed->poses[i].heading;
    EXPECT_LT(std::abs(turn), 0.6);
  }
}

TEST(PathSmoother, KeepsAChangeOfGearAndDrivesBackInReverse) {
  const Costmap map = empty_costmap(20, 20);
  Poses path = path_through(map, {{2, 2}, {15, 5}, {3, 12}});
  const std::size_t cusp = 13;
  ASSERT_EQ(path[cusp].point(), middle_of(map, 15, 5).point());
  for (std::size_t i = cusp; i < path.size(); ++i) path[i].heading += wend::kPi;
  const auto smoothed = smooth(map, path);
  ASSERT_TRUE(smoothed);
  EXPECT_EQ(smoothed->poses[cusp], path[cusp]);
  for (std::size_t i = cusp + 1; i + 1 < smoothed->poses.size(); ++i) {
    const wend::MapPose& pose = smoothed->poses[i];
    const wend::MapPose& next = smoothed->poses[i + 1];
    const double ahead =
        std::cos(pose.heading) * (next.x - pose.x) + std::sin(pose.heading) * (next.y - pose.y);
    EXPECT_LT(ahead, 0) << i;
  }
}

TEST(PathSmoother, RefusesAPathThatIsNotFree) {
  Costmap map = empty_costmap(20, 20);
  const Poses path = path_through(map, {{2, 2}, {15, 2}});
  map.at(7, 2) = 254;
  const auto smoothed = smooth(map, path);
  ASSERT_FALSE(smoothed);
  EXPECT_EQ(to_string(smoothed.error().kind), "no_valid_path");
}

TEST(PathSmoother, RefusesWhatIsNotFiniteOrOffTheCostmapWithThePlace) {
  const Costmap map = empty_costmap(40, 20);
  const auto fault_of = [&](std::size_t at, const wend::MapPose& pose, const std::string& name) {
    Poses path = path_through(map, {{2, 2}, {32, 2}});
    path[at] = pose;
    const auto smoothed = smooth(map, path, name);
    if (smoothed) return std::string("none");
    EXPECT_EQ(to_string(smoothed.error().kind), "no_valid_path");
    return smoothed.error().message;
  };
  for (const std::string name : {"gradient", "curvature"}) {
    for (const std::size_t at : {0U, 15U, 30U}) {
      const std::string pose = "pose " + std::to_string(at) + " of the path";
      for (const double number : {std::nan(""), double{INFINITY}, -double{INFINITY}, 1e300, 1e7}) {
        EXPECT_EQ(fault_of(at, {number, 0.25, 0}, name).find(pose), 0U) << number;
        EXPECT_EQ(fault_of(at, {0.25, -number, 0}, name).find(pose), 0U) << number;
      }
      EXPECT_EQ(fault_of(at, {0.25, 0.25, std::nan("")}, name).find(pose), 0U);
    }
  }
  EXPECT_EQ(fault_of(15, {4.5, 0.25, 0}, "gradient"),
            "pose 15 of the path, (4.5, 0.25), is outside the costmap, which reaches from (0, 0) "
            "to (4, 2)");
  PathSmoother smoother;
  EXPECT_FALSE(smoother.smooth({{1, 1, 0}, {std::nan(""), 1, 0}}, kSmallDisc, never));
}

TEST(PathSmoother, AStraightPathInReverseKeepsItsHeadingsAtZeroToo) {
  const Costmap map = empty_costmap(60, 20);
  for (const std::string name : {"gradient", "curvature"}) {
    for (const double heading : {0.0, 1e-9, 0.01}) {
      Poses path;
      for (int i = 0; i <= 40; ++i) {
        path.push_back({5 - 0.1 * i, 1 - 0.1 * i * std::tan(heading), heading});
      }
      const auto smoothed = smooth(map, path, name);
      ASSERT_TRUE(smoothed) << smoothed.error().message;
      for (const wend::MapPose& pose : smoothed->poses) EXPECT_NEAR(pose.heading, heading, 1e-3);
    }
  }
}

TEST(PathSmoother, TakesThePathsThatKeepOnlyTheCentreOutOfInscribedCells) {
  // A lethal cell, and around it what inflation by 0.1 m marks: the path passes at 0.09 m.
  Costmap map = empty_costmap(20, 20, 0.05);
  map.at(10, 10) = 254;
  for (const auto& [x, y] : {std::pair{9, 10}, {11, 10}, {10, 9}, {10, 11}}) map.at(x, y) = 253;
  Poses path;
  for (int i = 0; i <= 16; ++i) path.push_back({0.1 + 0.05 * i, 0.6, 0.01});
  for (const bool inflated : {true, false}) {
    PathSmoother smoother;
    smoother.costmap().read(map.layout, map.costs);
    const auto smoothed =
        smoother.smooth(path, RobotShape{wend::Footprint::disc(0.1), inflated}, never);
    EXPECT_EQ(smoothed.has_value(), inflated);
  }
}

TEST(PathSmoother, LeavesTheRestAsItIsWhenTheTimeIsUp) {
  const Costmap map = empty_costmap(20, 20);
  PathSmoother smoother;
  smoother.costmap().read(map.layout, map.costs);
  const Poses path = path_through(map, {{2, 2}, {15, 2}, {15, 15}});
  const auto result = smoother.smooth(path, kSmallDisc, [] { return true; });
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->complete);
  EXPECT_EQ(result->poses, path);
}

TEST(PathSmoother, LeavesAPathOfFewPosesAsItIs) {
  PathSmoother smoother;
  for (const std::size_t size : {0, 1, 2}) {
    const Poses path(size, wend::MapPose{1, 1, 0});
    EXPECT_EQ(smoother.smooth(path, kSmallDisc, never)->poses, path);
  }
}

TEST(SmootherSettings, TakeOptionsButNeverUnsafe) {
  const auto settings =
      smoother_settings_from("gradient", {{"beta", "0.4"}, {"allow_unknown", "false"}});
  ASSERT_TRUE(settings) << settings.error().message;
  EXPECT_EQ(settings->options, (wend::OptionValues{{"beta", "0.4"}}));
  EXPECT_FALSE(settings->plugin.allow_unknown);
  EXPECT_FALSE(smoother_settings_from("gradient", {{"unsafe", "true"}}));
  EXPECT_FALSE(smoother_settings_from("gradient", {{"alpha", "3"}}));
  EXPECT_FALSE(smoother_settings_from("drive", {}));
  EXPECT_TRUE(smoother_schema("drive").smoother.empty());
  EXPECT_FALSE(smoother_schema("curvature").smoother.empty());
}

}  // namespace
}  // namespace wend_nav2
