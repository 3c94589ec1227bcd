// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_planner.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "wend_nav2/costmaps_test.hpp"
#include "wend_nav2/path_length_test.hpp"
#include "wend_nav2/simulated_robot_test.hpp"

namespace wend_nav2 {
namespace {

using test::Costmap;
using test::costmap_of;
using test::empty_costmap;
using test::middle_of;

const RobotShape kRoundRobot{wend::Footprint::disc(0.1), true};

PlannerSettings settings_of(std::string_view planner, const wend::OptionValues& values = {}) {
  return *settings_from(planner, values);
}

/// For maps that are drawn as if inflated.
PlannerSettings inscribed(std::string_view planner, wend::OptionValues values = {}) {
  values.emplace_back("obstacles", "inscribed");
  return settings_of(planner, values);
}

wend::Expected<PathPlanner::Poses, Failure> plan(PathPlanner& planner, const Costmap& map,
                                                 const wend::MapPose& start,
                                                 const wend::MapPose& goal,
                                                 const RobotShape& robot = kRoundRobot,
                                                 const PathPlanner::CancelChecker& cancelled = {}) {
  planner.costmap().read(map.layout, map.costs);
  return planner.plan({start, goal, robot}, cancelled);
}

wend::Expected<PathPlanner::Poses, Failure> plan_once(const PlannerSettings& settings,
                                                      const Costmap& map,
                                                      const wend::MapPose& start,
                                                      const wend::MapPose& goal,
                                                      const RobotShape& robot = kRoundRobot) {
  PathPlanner planner;
  planner.set(settings);
  return plan(planner, map, start, goal, robot);
}

std::string kind_of(const wend::Expected<PathPlanner::Poses, Failure>& planned) {
  return planned ? "found" : std::string(to_string(planned.error().kind));
}

std::uint8_t cost_at(const Costmap& map, const wend::MapPose& pose) {
  return map.at(static_cast<int>(std::floor(pose.x / map.layout.resolution)),
                static_cast<int>(std::floor(pose.y / map.layout.resolution)));
}

const std::vector<std::string> kDoor{
    "........#.......",  //
    "........#.......",  //
    "........#.......",  //
    "................",  //
    "........#.......",  //
    "........#.......",
};

/// Cells that can be reached from a cell by steps to four neighbours whose costs are below 253.
std::vector<bool> reached_from(const Costmap& map, int x, int y) {
  std::vector<bool> reached(map.costs.size());
  std::vector<wend::Cell> open{{x, y}};
  reached[map.index(x, y)] = true;
  while (!open.empty()) {
    const wend::Cell at = open.back();
    open.pop_back();
    for (const wend::Cell to : {wend::Cell{at.x + 1, at.y}, wend::Cell{at.x - 1, at.y},
                                wend::Cell{at.x, at.y + 1}, wend::Cell{at.x, at.y - 1}}) {
      const bool inside =
          to.x >= 0 && to.y >= 0 && to.x < map.layout.width && to.y < map.layout.height;
      if (!inside || reached[map.index(to.x, to.y)] || map.at(to.x, to.y) >= 253) continue;
      reached[map.index(to.x, to.y)] = true;
      open.push_back(to);
    }
  }
  return reached;
}

RC_GTEST_PROP(PathPlanner, FindsAPathOfFreeCellsIfThereIsOneAndSaysWhyElse, ()) {
  const int width = *rc::gen::inRange(2, 14);
  const int height = *rc::gen::inRange(2, 14);
  Costmap map = empty_costmap(width, height);
  for (auto& cost : map.costs) {
    const int kind = *rc::gen::inRange(0, 6);
    cost = std::vector<std::uint8_t>{0, 0, 0, 120, 253, 254}[static_cast<std::size_t>(kind)];
  }
  const int sx = *rc::gen::inRange(0, width);
  const int sy = *rc::gen::inRange(0, height);
  const int gx = *rc::gen::inRange(0, width);
  const int gy = *rc::gen::inRange(0, height);
  const auto name =
      *rc::gen::elementOf(std::vector<std::string>{"astar", "jps", "theta_star", "any_angle"});
  const auto planned = plan_once(inscribed(name, {{"tolerance", "0"}, {"escape", "0"}}), map,
                                 middle_of(map, sx, sy), middle_of(map, gx, gy));
  if (map.at(sx, sy) >= 253) {
    RC_ASSERT(kind_of(planned) == "start_occupied");
  } else if (map.at(gx, gy) >= 253) {
    RC_ASSERT(kind_of(planned) == "goal_occupied");
  } else if (!reached_from(map, sx, sy)[map.index(gx, gy)]) {
    RC_ASSERT(kind_of(planned) == "no_valid_path");
  } else {
    RC_ASSERT(kind_of(planned) == "found");
    for (std::size_t i = 0; i < planned->size(); ++i) {
      const wend::MapPose& pose = (*planned)[i];
      // On the border of cells, the free one counts.
      const auto near = [&](double dx, double dy) {
        return cost_at(map, {pose.x + dx * 1e-6, pose.y + dy * 1e-6, 0}) < 253;
      };
      RC_ASSERT(near(1, 1) || near(-1, 1) || near(1, -1) || near(-1, -1));
      if (i > 0) RC_ASSERT(distance(pose.point(), (*planned)[i - 1].point()) <= 0.1 + 1e-9);
    }
  }
}

TEST(PathPlanner, BeginsAndEndsWhereItWasAskedTo) {
  const Costmap map = costmap_of(kDoor);
  const wend::MapPose start{0.23, 0.17, 1};
  const wend::MapPose goal{1.44, 0.51, -2};
  for (const std::string planner : {"astar", "theta_star", "hybrid_astar"}) {
    const auto planned = plan_once(inscribed(planner), map, start, goal);
    ASSERT_EQ(kind_of(planned), "found") << planned.error().message;
    EXPECT_NEAR(planned->front().x, start.x, 1e-6) << planner;
    EXPECT_NEAR(planned->front().y, start.y, 1e-6) << planner;
    EXPECT_NEAR(planned->back().x, goal.x, 1e-6) << planner;
    EXPECT_NEAR(planned->back().y, goal.y, 1e-6) << planner;
    EXPECT_NEAR(planned->back().heading, goal.heading, 1e-6) << planner;
  }
}

TEST(PathPlanner, OfOneCellGoesFromPoseToPose) {
  const Costmap map = empty_costmap(4, 4);
  const auto planned = plan_once(inscribed("astar"), map, {0.12, 0.12, 0}, {0.18, 0.18, 1});
  ASSERT_EQ(kind_of(planned), "found");
  ASSERT_EQ(planned->size(), 2U);
  EXPECT_EQ(planned->back(), (wend::MapPose{0.18, 0.18, 1}));
}

TEST(PathPlanner, NeverTakesABoxedInStartForAnOccupiedOne) {
  const Costmap map = costmap_of({
      "#####.....",  //
      "#...#.....",  //
      "#...#.....",  //
      "#####.....",
  });
  const wend::MapPose free = middle_of(map, 8, 2);
  const auto kind = [&](const wend::MapPose& start, const wend::MapPose& goal) {
    return kind_of(
        plan_once(inscribed("astar", {{"tolerance", "0"}, {"escape", "0"}}), map, start, goal));
  };
  EXPECT_EQ(kind(middle_of(map, 2, 1), free), "no_valid_path");
  EXPECT_EQ(kind(middle_of(map, 4, 1), free), "start_occupied");
  EXPECT_EQ(kind({-1, 0, 0}, free), "start_outside");
  EXPECT_EQ(kind(free, {5, 5, 0}), "goal_outside");
  EXPECT_EQ(kind({NAN, 0, 0}, free), "other");
}

TEST(PathPlanner, ASearchWithoutTimeIsNoProofThatThereIsNoPath) {
  const Costmap map = costmap_of({"..#..", "..#.."});
  const auto planned = plan_once(inscribed("astar", {{"time_limit", "1e-9"}}), map,
                                 middle_of(map, 0, 0), middle_of(map, 4, 0));
  EXPECT_EQ(kind_of(planned), "timed_out");
}

TEST(PathPlanner, StopsWhenItIsCancelled) {
  const Costmap map = empty_costmap(200, 200);
  PathPlanner planner;
  planner.set(inscribed("dijkstra"));
  int asked = 0;
  const auto after = [&](int calls) { return [&asked, calls] { return ++asked > calls; }; };
  EXPECT_EQ(kind_of(plan(planner, map, middle_of(map, 0, 0), middle_of(map, 199, 199), kRoundRobot,
                         after(0))),
            "cancelled");
  asked = 0;
  EXPECT_EQ(kind_of(plan(planner, map, middle_of(map, 0, 0), middle_of(map, 199, 199), kRoundRobot,
                         after(5))),
            "cancelled");
  EXPECT_LT(asked, 20);
  asked = 0;
  EXPECT_EQ(kind_of(plan(planner, map, middle_of(map, 0, 0), middle_of(map, 199, 199), kRoundRobot,
                         after(1'000'000))),
            "found");
  EXPECT_GT(asked, 50);
}

TEST(PathPlanner, EndsNearAGoalThatCannotBeReachedIfItMay) {
  const Costmap map = costmap_of({
      "............",  //
      ".......###..",  //
      ".......#.#..",  //
      ".......###..",  //
      "............",
  });
  const wend::MapPose start = middle_of(map, 0, 2);
  for (const int x : {8, 9}) {
    const wend::MapPose goal = middle_of(map, x, 2);
    const auto refused = plan_once(inscribed("astar", {{"tolerance", "0"}}), map, start, goal);
    EXPECT_EQ(kind_of(refused), x == 8 ? "no_valid_path" : "goal_occupied");
    const auto planned = plan_once(inscribed("astar", {{"tolerance", "0.4"}}), map, start, goal);
    ASSERT_EQ(kind_of(planned), "found");
    EXPECT_LE(distance(planned->back().point(), goal.point()), 0.4 + 1e-9);
    EXPECT_LT(cost_at(map, planned->back()), 253);
  }
}

TEST(PathPlanner, BeginsWithAWayOutOfWhatBlocksTheStart) {
  const Costmap map = costmap_of({
      "............",  //
      "............",  //
      "###.........",  //
      "###.........",  //
      "###.........",
  });
  const wend::MapPose goal = middle_of(map, 9, 3);
  for (const std::string name : {"astar", "theta_star", "hybrid_astar", "lattice"}) {
    SCOPED_TRACE(name);
    const auto kind = [&](int x, const std::string& escape) {
      return kind_of(plan_once(settings_of(name, {{"tolerance", "0"}, {"escape", escape}}), map,
                               middle_of(map, x, 1), goal));
    };
    EXPECT_EQ(kind(2, "0"), "start_occupied");
    EXPECT_EQ(kind(2, "0.3"), "found");
    EXPECT_EQ(kind(0, "0.05"), "start_occupied");
  }
  EXPECT_EQ(kind_of(plan_once(settings_of("astar"), map, middle_of(map, 2, 1), goal)), "found")
      << "0.25 m by default";
}

TEST(PathPlanner, EndsAtTheClosestPlaceIfItMay) {
  const Costmap map = costmap_of({
      "............",  //
      ".....#####..",  //
      ".....#...#..",  //
      ".....#####..",  //
      "............",
  });
  const wend::MapPose start = middle_of(map, 0, 2);
  const wend::MapPose goal = middle_of(map, 7, 2);
  const auto planned = [&](const std::string& closest) {
    return plan_once(inscribed("astar", {{"tolerance", "0.1"}, {"closest", closest}}), map, start,
                     goal);
  };
  EXPECT_EQ(kind_of(planned("false")), "no_valid_path");
  const auto found = planned("true");
  ASSERT_EQ(kind_of(found), "found");
  EXPECT_LT(distance(found->back().point(), goal.point()), 0.31);
}

TEST(PathPlanner, AnsweringAfterChangesIsAnsweringAnew) {
  for (const std::string name : {"astar", "jps", "d_star_lite"}) {
    PathPlanner warm;
    warm.set(inscribed(name, {{"smooth", "false"}}));
    Costmap map = costmap_of(kDoor);
    const wend::MapPose start = middle_of(map, 1, 4);
    const wend::MapPose goal = middle_of(map, 14, 0);
    for (int n = 0; n < 6; ++n) {
      map.at(8, 2) = n % 2 == 0 ? 0 : 254;
      map.at(3, n) = 252;
      const auto again = plan(warm, map, start, goal);
      const auto anew = plan_once(warm.settings(), map, start, goal);
      EXPECT_EQ(kind_of(again), n % 2 == 0 ? "found" : "no_valid_path") << name;
      EXPECT_EQ(kind_of(again), kind_of(anew));
      if (again) {
        EXPECT_EQ(again->size(), anew->size()) << name;
      }
    }
    EXPECT_EQ(warm.costmap().given().maps, 1U);
    EXPECT_EQ(warm.costmap().given().edits, 5U);
  }
}

/// Of every planner: a path of poses keeps its headings and its turning radius.
TEST(PathPlanner, ReplansWithAllThatWasAskedFor) {
  Costmap map = empty_costmap(60, 60);
  for (int y = 0; y < 40; ++y) map.at(30, y) = 254;
  const wend::MapPose start{map.layout.resolution * 10.5, map.layout.resolution * 10.5, 0};
  const wend::MapPose goal{map.layout.resolution * 50.5, map.layout.resolution * 10.5, -1.5};
  for (const wend::PlannerInfo& info : wend::planners()) {
    if (info.name == "random_walk") continue;
    SCOPED_TRACE(info.name);
    const auto fresh = plan_once(settings_of(info.name), map, start, goal);
    const auto again = plan_once(settings_of(info.name, {{"replan", "true"}}), map, start, goal);
    EXPECT_EQ(kind_of(again), kind_of(fresh));
    if (!fresh || !again) continue;
    if (info.guarantee != wend::Guarantee::optimal) {
      EXPECT_NEAR(test::path_length(*again), test::path_length(*fresh),
                  0.03 * test::path_length(*fresh));
    }
    if (!info.capabilities.headings) continue;
    ASSERT_EQ(again->size(), fresh->size());
    for (std::size_t i = 0; i < fresh->size(); ++i) {
      EXPECT_NEAR(distance((*again)[i].point(), (*fresh)[i].point()), 0, 1e-9);
      EXPECT_NEAR((*again)[i].heading, (*fresh)[i].heading, 1e-9);
    }
  }
}

TEST(PathPlanner, KeepsAPathUnlessAnotherIsCheaperByTheShare) {
  for (const std::string name : {"astar", "theta_star", "hybrid_astar"}) {
    for (const std::string keep : {"0", "0.9"}) {
      PathPlanner warm;
      warm.set(settings_of(name, {{"smooth", "false"}, {"replan", "true"}, {"keep", keep}}));
      Costmap map = empty_costmap(60, 60);
      for (int y = 0; y < 40; ++y) map.at(30, y) = 254;
      const wend::MapPose start{map.layout.resolution * 10.5, map.layout.resolution * 10.5, 0};
      const wend::MapPose goal{map.layout.resolution * 50.5, map.layout.resolution * 10.5, 0};
      const auto around = plan(warm, map, start, goal);
      for (int y = 5; y < 20; ++y) map.at(30, y) = 0;
      const auto again = plan(warm, map, start, goal);
      ASSERT_TRUE(around && again) << name;
      if (keep == "0.9") {
        EXPECT_NEAR(test::path_length(*again), test::path_length(*around), 1e-6) << name;
      } else {
        EXPECT_LT(test::path_length(*again), 0.8 * test::path_length(*around)) << name;
      }
    }
  }
}

TEST(PathPlanner, ARobotThatIsNotRoundFitsWithItsFootprint) {
  Costmap map = empty_costmap(20, 18);
  for (int x = 0; x < 20; ++x) {
    if (x < 8 || x >= 12) map.at(x, 8) = map.at(x, 9) = 254;
  }
  const wend::MapPose start = middle_of(map, 5, 4);
  const wend::MapPose goal = middle_of(map, 14, 13);
  const std::vector<wend::MapPoint> corners{{0.3, 0.15}, {-0.3, 0.15}, {-0.3, -0.15}, {0.3, -0.15}};
  const RobotShape box{*footprint_from(corners), true};
  const auto hybrid =
      settings_of("hybrid_astar", {{"motion_model", "differential"}, {"tolerance", "0"}});
  const auto through = plan_once(hybrid, map, start, goal, box);
  ASSERT_EQ(kind_of(through), "found") << through.error().message;
  // Its circumscribed disc, which planners on cells need, does not pass the gap of 0.4 m.
  const auto astar = settings_of("astar", {{"tolerance", "0"}});
  EXPECT_EQ(kind_of(plan_once(astar, map, start, goal, box)), "no_valid_path");
  EXPECT_EQ(kind_of(plan_once(inscribed("astar"), map, start, goal, box)), "found");
  const std::vector<wend::MapPoint> wide{{0.3, 0.25}, {-0.3, 0.25}, {-0.3, -0.25}, {0.3, -0.25}};
  EXPECT_EQ(kind_of(plan_once(hybrid, map, start, goal, {*footprint_from(wide), true})),
            "no_valid_path");
}

TEST(PathPlanner, DrivesIntoUnknownCellsOnlyIfItMay) {
  const Costmap map = costmap_of({"..??..", "..??.."});
  const auto ask = [&](const std::string& allowed) {
    return kind_of(plan_once(inscribed("astar", {{"allow_unknown", allowed}}), map,
                             middle_of(map, 0, 0), middle_of(map, 5, 1)));
  };
  EXPECT_EQ(ask("true"), "found");
  EXPECT_EQ(ask("false"), "found") << "as near to the goal as the tolerance says";
  const Costmap wide = costmap_of({"..?????????.."});
  EXPECT_EQ(kind_of(plan_once(inscribed("astar", {{"allow_unknown", "false"}}), wide,
                              middle_of(wide, 0, 0), middle_of(wide, 12, 0))),
            "no_valid_path");
}

TEST(PathPlanner, CostsKeepThePathAwayAsFarAsTheFactorSays) {
  const Costmap map = costmap_of({
      ".......",  //
      ".......",  //
      "..999..",  //
      ".......",
  });
  const auto dearest = [&](const std::string& factor) {
    const auto planned =
        plan_once(inscribed("astar", {{"cost_factor", factor}, {"smooth", "false"}}), map,
                  middle_of(map, 0, 1), middle_of(map, 6, 1));
    std::uint8_t most = 0;
    for (const wend::MapPose& pose : *planned) most = std::max(most, cost_at(map, pose));
    return most;
  };
  EXPECT_EQ(dearest("4"), 0);
  EXPECT_EQ(dearest("0"), 252);
}

RC_GTEST_PROP(PathPlanner, KeepsARoundRobotOutOfObstaclesByItsRadius, ()) {
  Costmap map = empty_costmap(24, 24, 0.05);
  const int walls = *rc::gen::inRange(0, 30);
  for (int i = 0; i < walls; ++i) {
    const int x = *rc::gen::inRange(0, 24);
    const int y = *rc::gen::inRange(0, 24);
    map.at(x, y) = 254;
  }
  const double radius = *rc::gen::inRange(3, 16) / 100.0;
  const RobotShape robot{wend::Footprint::disc(radius), true};
  const auto name = *rc::gen::elementOf(
      std::vector<std::string>{"astar", "jps", "any_angle", "theta_star", "hybrid_astar"});
  const auto planned = plan_once(settings_of(name, {{"spacing", "0.01"}, {"escape", "0"}}), map,
                                 middle_of(map, 4, 4, 1), middle_of(map, 19, 19, 2), robot);
  if (!planned) return;
  for (const wend::MapPose& pose : *planned) RC_ASSERT(!test::collides(map, pose, radius));
}

TEST(PathPlanner, NamesTheEndThatIsNotFinite) {
  const Costmap map = empty_costmap(5, 5);
  const wend::MapPose middle = middle_of(map, 2, 2);
  for (const double number : {std::nan(""), double{INFINITY}}) {
    const auto start = plan_once(settings_of("astar"), map, {number, 0.2, 0}, middle);
    ASSERT_EQ(kind_of(start), "other");
    EXPECT_EQ(start.error().message.find("the start ("), 0U);
    const auto goal = plan_once(settings_of("astar"), map, middle, {0.2, 0.2, number});
    ASSERT_EQ(kind_of(goal), "other");
    EXPECT_EQ(goal.error().message, "the goal (0.2, 0.2) contains NaN or infinity");
  }
  EXPECT_EQ(kind_of(plan_once(settings_of("astar"), map, middle, {1e300, 0, 0})), "goal_outside");
}

TEST(PathPlanner, WrongOptionsOfAPlannerAreAnInvalidPlanner) {
  const Costmap map = empty_costmap(5, 5);
  PlannerSettings settings = settings_of("astar");
  settings.options = {{"no_such", "1"}};
  EXPECT_EQ(kind_of(plan_once(settings, map, middle_of(map, 0, 0), middle_of(map, 4, 4))),
            "invalid_planner");
  PathPlanner without_costs;
  EXPECT_EQ(kind_of(without_costs.plan({{}, {}, kRoundRobot}, {})), "other");
}

TEST(PathPlanner, SaysHowFarAnEndWasMoved) {
  const Costmap map = costmap_of(kDoor);
  PathPlanner planner;
  planner.set(inscribed("astar", {{"nearest", "true"}}));
  const wend::MapPose start = middle_of(map, 1, 1);
  ASSERT_TRUE(plan(planner, map, start, middle_of(map, 14, 4)));
  EXPECT_EQ(planner.shifts(), "");
  const auto moved = plan(planner, map, start, middle_of(map, 8, 1));
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_EQ(planner.shifts(), "the goal 0.1 m from what was asked");
}

}  // namespace
}  // namespace wend_nav2
