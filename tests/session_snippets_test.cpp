// The snippets of the headers of sessions, compiled and run as they stand there.

#include <gtest/gtest.h>

#include "tests/snippets.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/session/session.hpp"

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
  const wend::Place start = units.place("start", wend::Cell{1, 1});
  const wend::Place goal = units.place("goal", wend::Cell{-5, 1});
  const auto query = wend::Query::between(start.cell, goal.cell);
  const wend::SearchMetrics metrics;
  const auto status = wend::Status::goal_outside;
  reported.clear();
  {
    const wend::Explainer explainer(space, wend::Units(space.map()), {}, {});
    report(explainer.explain(status, {start, {goal}}, query.limits, metrics));
  }
  EXPECT_TRUE(reported.starts_with("the goal (-5,1) is outside the map")) << reported;
}

}  // namespace
