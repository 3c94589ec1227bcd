// The snippets of the headers of sessions, compiled and run as they stand there.

#include <gtest/gtest.h>

#include <iostream>
#include <span>
#include <vector>

#include "tests/snippets/snippets.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/base/metric.hpp"
#include "wend/explore/explorer.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/map/place_text.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/robot_fields.hpp"
#include "wend/robot/sweep/overlap.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/request_fields.hpp"
#include "wend/session/session.hpp"
#include "wend/session/shift_text.hpp"
#include "wend/session/way_out.hpp"

namespace {

using wend::test::OfficeInWorkingFolder;
using wend::test::open_ground;
using wend::test::report;
using wend::test::reported;

TEST(Snippets, OfASession) {
  const OfficeInWorkingFolder office;
  reported.clear();
  int poses = 0;
  const auto drive_to = [&](const wend::MapPose& /*pose*/) { ++poses; };
  [&] {
    const auto map = wend::load_map("office.yaml");
    wend::Session session(map->map, {.footprint = wend::Footprint::disc(0.2)});
    const auto answer = session.plan({{1, 1, 0}, {{{15, 9}}}});
    if (!answer) return report(answer.error().message);
    for (const wend::MapPose& pose : answer->poses()) drive_to(pose);
  }();
  EXPECT_EQ(
      reported,
      "the start (1,1) m, cell (10,10) is outside the map, which covers x from 0 to 0.4 m and y "
      "from 0 to 0.3 m");
  EXPECT_EQ(poses, 0);
  wend::PlanRequest request{{1, 1, 0}, {{{15, 9}}}};
  request.planner.name = "jps";
  request.refinement.smoother = wend::SmootherChoice{"gradient"};
  wend::Session session(
      *wend::make_grid_map(wend::Grid<wend::CellState>(20, 20, wend::CellState::free)));
  EXPECT_TRUE(session.plan(request)->refined);
}

TEST(Snippets, OfASearchRun) {
  wend::Session session(
      *wend::make_grid_map(wend::Grid<wend::CellState>(20, 20, wend::CellState::free)));
  wend::PlanRequest request{{1, 1, 0}, {{{15, 9}}}};
  std::uint64_t shown = 0;
  const auto show = [&](const wend::OpenList& open, const wend::SearchMetrics& metrics) {
    EXPECT_LE(open.entries.size(), 10U);
    EXPECT_EQ(metrics.expanded, ++shown);
  };
  reported.clear();
  [&] {
    auto run = session.begin(request);
    if (!run) return report(run.error().message);
    while (!run->step()) show(run->open_list(10), run->plan().metrics);
    const auto answer = run->finish();
    EXPECT_TRUE(answer);
  }();
  EXPECT_GT(shown, 5U);
  EXPECT_EQ(reported, "");
  request.planner.name = "ara_star";
  auto run = session.begin(request);
  ASSERT_TRUE(run);
  int paths = 0;
  const auto drive_along = [&](const std::vector<wend::MapPose>& /*poses*/) { ++paths; };
  while (const auto better = run->next_solution()) drive_along(better->poses());
  EXPECT_GT(paths, 0);
}

TEST(Snippets, OfWarmPlanners) {
  const wend::FreeSpace space = open_ground();
  const std::uint64_t version = 1;
  const wend::PlannerSpec spec{"astar"};
  const auto query = wend::Query::between({1, 1}, {2, 2});
  reported.clear();
  [&] {
    wend::WarmPlanners planners(2);
    auto planner = planners.take(space, version, spec);
    if (!planner) return report(planner.error().message);
    const auto plan = (*planner)->plan(query);
    EXPECT_TRUE(plan);
  }();
  EXPECT_TRUE(reported.empty()) << reported;
}

TEST(Snippets, OfExplanations) {
  const wend::FreeSpace space = open_ground();
  const double clearance = 1.25;
  const wend::Point door{2.5, 2.5};
  reported.clear();
  const wend::Units units(space.map());
  report("the door is " + units.length(2 * clearance) + " wide, at " + units.text(door));
  EXPECT_EQ(reported, "the door is 2.5 cells wide, at cell (2,2)");
  const auto made = wend::make_planner("astar", space);
  const wend::Planner& planner = **made;
  const wend::Place start = units.place("start", wend::Cell{1, 1});
  const wend::Place goal = units.place("goal", wend::Cell{-5, 1});
  const wend::Ends ends{start, {goal}};
  const auto query = wend::Query::between(start.cell, goal.cell);
  const wend::SearchMetrics metrics;
  const auto status = wend::Status::goal_outside;
  reported.clear();
  {
    const wend::Explainer explainer(space, wend::Units(space.map()), {}, {});
    report(explainer.explain(planner, query, ends, planner.failure(query, status), metrics));
  }
  EXPECT_TRUE(reported.starts_with("the goal (-5,1) is outside the map")) << reported;
}

TEST(Snippets, OfFailures) {
  const wend::FreeSpace space = *wend::make_free_space(wend::test::drawn_map("....\n...#\n...."));
  const auto planner = std::move(wend::make_planner("astar", space).value());
  const auto query = wend::Query::between({0, 0}, {3, 1});
  std::optional<wend::Cell> looked_at;
  const auto look_at = [&](std::optional<wend::Cell> cell) { looked_at = cell; };
  reported.clear();
  {
    const auto plan = planner->plan(query);
    if (!plan) {
      for (const wend::FailureCause& cause : plan.error().failure.causes) {
        if (const auto* blocked = std::get_if<wend::EndBlocked>(&cause)) look_at(blocked->cell);
      }
      report(wend::words_of(plan.error(), space));
    }
  }
  EXPECT_EQ(looked_at, (wend::Cell{3, 1}));
  EXPECT_EQ(reported, "the goal (3,1) is blocked: the cell is an obstacle");
  reported.clear();
  [&] {
    const auto plan = planner->plan(query);
    if (!plan) return report(wend::words_of(plan.error(), space));
  }();
  EXPECT_FALSE(reported.empty());
}

TEST(Snippets, OfShiftText) {
  const wend::FreeSpace space = open_ground();
  wend::Plan plan;
  plan.goal_snapping_error = {2, 0};
  reported.clear();
  {
    const wend::Units units(space.map());
    report(wend::shifts_text(plan.start_snapping_error, plan.goal_snapping_error, units));
  }
  EXPECT_EQ(reported, "the goal 2 cells from what was asked");
}

TEST(Snippets, OfPlaceText) {
  const wend::FreeSpace space = open_ground();
  const wend::GridMap& map = space.map();
  const wend::Pose pose{2, 1, 0};
  reported.clear();
  {
    report("the robot stands at " + wend::pose_text(pose, map.frame()));
  }
  EXPECT_EQ(reported, "the robot stands at (2,1,E)");
}

/// A wall at the left edge, which a robot touches.
wend::FreeSpace beside_wall() {
  wend::Grid<wend::CellState> cells(20, 9, wend::CellState::free);
  for (int y = 0; y < 9; ++y) cells[{0, y}] = wend::CellState::occupied;
  return *wend::make_free_space(*wend::make_grid_map(cells),
                                {.footprint = wend::Footprint::disc(1.3)});
}

TEST(Snippets, OfOverlapsAndLeads) {
  const wend::FreeSpace space = beside_wall();
  const double resolution = space.map().frame().resolution;
  const wend::Pose here{2.1, 4.5, 0};
  const wend::Pose there{1.9, 4.5, 0};
  const wend::OverlapMeasure measure(space);
  const bool deeper = measure.at(there).exceeds(measure.at(here));
  EXPECT_TRUE(deeper);
  const wend::Path path = wend::Path::along({{2.1, 4.5}, {9.5, 4.5}});
  reported.clear();
  const auto checked = wend::check_with_lead(path, space, 0.25 / resolution);
  if (checked.collision) report(wend::describe(checked.collision->kind));
  EXPECT_EQ(reported, "");
}

TEST(Snippets, OfWaysOut) {
  const wend::FreeSpace space = beside_wall();
  const double resolution = space.map().frame().resolution / 8;
  const auto made = *wend::make_planner("astar", space, {});
  wend::Planner& planner = *made;
  wend::Query query = wend::Query::between({1, 4}, {30, 4});
  {
    const auto way = wend::way_out(planner, query.start, 0.25 / resolution);
    if (way) query.start = way->path.poses().back();
    EXPECT_EQ(query.start.point(), (wend::Point{2.5, 4.5}));
  }
  query = wend::Query::between({1, 4}, {30, 4});
  const wend::Leeway leeway{.escape = 2, .closest = true};
  wend::Explainer explainer(space, wend::Units(space.map()), {}, {});
  explainer.allow(leeway);
  wend::Plan plan;
  wend::EasedQuery eased(query, planner, explainer, wend::Units(space.map()), leeway);
  wend::Status status = planner.plan(eased.query(), plan);
  if (eased.ease_goals(status)) status = planner.plan(eased.query(), plan);
  if (status == wend::Status::found) eased.finish(plan);
  ASSERT_TRUE(eased.lead_out());
  EXPECT_EQ(eased.lead_out()->length, 1);
  EXPECT_EQ(eased.remaining(), 11);
}

TEST(Snippets, OfReplanning) {
  wend::Session session(
      *wend::make_grid_map(wend::Grid<wend::CellState>(20, 20, wend::CellState::free)));
  wend::PlanRequest request{{1, 1, 0}, {{{15, 9}}}};
  int steps = 0;
  const auto arrived = [&] { return steps > 5; };
  const auto drive_along = [&](const std::vector<wend::MapPose>& poses) {
    ++steps;
    return poses.size() > 1 ? poses[1] : poses[0];
  };
  const auto what_the_robot_sees = [&] {
    return wend::MapEdit{.cells = {{{10 + steps % 2, 5 + steps % 3}, wend::CellState::occupied}}};
  };
  auto answer = session.replan(request);
  while (answer && !arrived()) {
    request.start = drive_along(answer->poses());
    if (session.edit(what_the_robot_sees())) answer = session.replan(request);
  }
  EXPECT_TRUE(answer);
  EXPECT_EQ(steps, 6);
}

TEST(Snippets, OfExplorationAndItsPlanner) {
  const auto space = *wend::make_free_space(
      *wend::make_grid_map(wend::Grid<wend::CellState>(50, 70, wend::CellState::free)));
  const wend::GridMap map = space.map();
  std::size_t drawn = 0;
  const auto draw = [&](const wend::FreeSpace& /*believed*/, std::span<const wend::Cell> ahead) {
    drawn += ahead.size();
  };
  [&] {
    auto explorer = wend::Explorer::make(map, {2, 3}, {40, 60}, {.sensor_range = 30});
    if (!explorer) return report(explorer.error().message);
    while (!explorer->step()) draw(explorer->believed(), explorer->ahead());
    std::cout << explorer->totals().replans << " plans\n";
  }();
  EXPECT_GT(drawn, 0U);
  const auto planner = wend::make_planner(space, wend::ReplannerOptions{});
  EXPECT_TRUE(planner);
}

TEST(Snippets, OfListsOfFieldsAndMetrics) {
  const auto map = *wend::make_grid_map(wend::Grid<wend::CellState>(20, 20, wend::CellState::free));
  wend::PlanRequest request{{1, 1, 0}, {{{15, 9}}}};
  const wend::RequestField* const escape = wend::request_field("escape");
  const auto set = escape->set(request, 0.5, map.frame().resolution);
  EXPECT_TRUE(set);
  EXPECT_EQ(request.escape, 0.5);
  [] {
    wend::FreeSpaceOptions robot;
    const auto set = wend::robot_field("clearance_distance")->set(robot, 0.5);
    EXPECT_TRUE(set);
    EXPECT_EQ(robot.clearance_distance, 0.5);
  }();
  const auto space = *wend::make_free_space(map);
  const wend::Path path(std::vector<wend::Cell>{{1, 1}, {1, 2}, {1, 3}});
  for (const wend::Metric& metric : wend::metrics_of(*wend::measure(path, space))) {
    std::cout << metric.name << ": " << metric.value << '\n';
  }
}

}  // namespace
