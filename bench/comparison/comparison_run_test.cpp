#include "bench/comparison/comparison_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

/// A clock that advances by a second at each reading.
Clock ticking_clock() {
  return [now = 0.0]() mutable { return now += 1; };
}

ComparisonRun run_of(const FreeSpace& space, std::string_view planners) {
  return *ComparisonRun::make(space, *parse_planner_specs(planners), ticking_clock());
}

TEST(RandomPairs, AreConnectedDifferentAndFree) {
  int maps_with_pairs = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const FreeSpace space = *make_free_space(test::random_map(random));
    const auto pairs = random_pairs(space, 20, seed);
    maps_with_pairs += pairs.empty() ? 0 : 1;
    for (const CellPair& cells : pairs) {
      EXPECT_NE(cells.start, cells.goal);
      EXPECT_TRUE(space.components().connected(cells.start, cells.goal, Adjacency::edges));
    }
    const auto sizes = space.components().sizes(Adjacency::edges);
    const bool some = !sizes.empty() && sizes.front() > 1;
    EXPECT_EQ(pairs.size(), some ? 20U : 0U);
  }
  EXPECT_GT(maps_with_pairs, 100);
}

/// A planner that keeps what it prepared goes another way when it is asked again: its path is there all the same.
TEST(ComparisonRun, HasThePathOfEveryQueryThatWasAnswered) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const FreeSpace space = *make_free_space(*make_grid_map(
        test::random_states(random, random.between(20, 40), random.between(20, 60))));
    ComparisonRun run = run_of(space, "jps,astar,any_angle,replanner,d_star_lite,alt");
    for (const CellPair& cells : random_pairs(space, 3, seed)) {
      run.answer(Query::between(cells.start, cells.goal));
    }
    for (std::size_t query = 0; query < run.comparison().queries.size(); ++query) {
      const auto& rows = run.comparison().queries[query].rows;
      for (std::size_t planner = 0; planner < rows.size(); ++planner) {
        if (!rows[planner].found()) continue;
        ++found;
        EXPECT_FALSE(run.path(planner, query).empty()) << rows[planner].planner << " seed " << seed;
      }
    }
  }
  EXPECT_GT(found, 200);
}

/// Such a planner would have nothing to do, and to show, when it is asked again.
TEST(ComparisonRun, CountsAndRecordsTheFirstSearchOfPlannersThatResume) {
  const FreeSpace space = test::open_space(30, 20);
  ComparisonRun run = run_of(space, "replanner,d_star_lite,alt,astar");
  run.answer({{0, 0}, {29, 19}});
  run.answer({{0, 0}, {29, 19}});
  for (const ComparedQuery& query : run.comparison().queries) {
    for (std::size_t planner = 0; planner < query.rows.size(); ++planner) {
      const ComparisonRow& row = query.rows[planner];
      SCOPED_TRACE(row.planner);
      EXPECT_EQ(row.counts_first_query, row.planner != "astar");
      const auto fresh = make_planner(row.planner, space, {});
      const auto plan = (*fresh)->plan(Query::between({0, 0}, {29, 19}));
      ASSERT_TRUE(plan);
      EXPECT_EQ(row.expanded, plan->metrics.expanded);
      EXPECT_EQ(row.generated, plan->metrics.generated);
      EXPECT_GT(row.expanded, 0U);
      EXPECT_FALSE(run.record(planner, 0).expansions().empty());
    }
  }
  EXPECT_THAT(comparison_table(run.comparison(), 200),
              testing::Not(testing::HasSubstr("counted in")))
      << "of many";
  ComparisonRun single = run_of(space, "replanner,astar");
  single.answer({{0, 0}, {29, 19}});
  EXPECT_THAT(comparison_table(single.comparison(), 200),
              testing::HasSubstr("replanner: counted in the first query, as its answer is kept\n"));
}

TEST(RandomPairs, ReachAllCellsAndComeAgainWithTheSameSeed) {
  const FreeSpace space = test::drawn_space("..#..\n..#.#\n");
  std::set<Cell> seen;
  const auto pairs = random_pairs(space, 500, 3);
  for (const CellPair& cells : pairs) seen.insert({cells.start, cells.goal});
  EXPECT_EQ(seen.size(), 7U);
  const auto again = random_pairs(space, 500, 3);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(pairs[i].start, again[i].start);
    EXPECT_EQ(pairs[i].goal, again[i].goal);
  }
}

TEST(RandomDrives, AreBetweenCornersWhereACarCanStand) {
  int maps_with_drives = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const GridMap map = test::random_map(random);
    const FreeSpace space =
        *make_free_space(map, test::random_robot(random, map.frame().resolution));
    const int unit = random.between(1, 3);
    const auto drives = random_drives(space, corners_of(space, unit), 20, seed);
    const auto planner = make_planner("car", space, {{"lattice_resolution", std::to_string(unit)}});
    if (drives.empty()) continue;
    ASSERT_TRUE(planner);
    ++maps_with_drives;
    EXPECT_EQ(drives.size(), 20U);
    for (const Query& query : drives) {
      const auto plan = (*planner)->plan(query);
      const Status status = plan ? Status::found : plan.error().status;
      EXPECT_TRUE(status == Status::found || status == Status::unreachable) << to_string(status);
      EXPECT_NE(query.start.point(), query.goals.front().point);
      if (plan) {
        EXPECT_EQ(plan->start_snapping_error, SnappingError{}) << "where it was asked";
        EXPECT_EQ(plan->goal_snapping_error, SnappingError{});
      }
    }
  }
  EXPECT_GT(maps_with_drives, 30);
}

TEST(RandomDrives, FaceAllWaysAndComeAgainWithTheSameSeed) {
  const FreeSpace space = test::open_space(2, 1);
  const auto drives = random_drives(space, corners_of(space), 500, 3);
  std::set<std::array<double, 3>> starts;
  std::set<std::array<double, 3>> goals;
  for (const Query& query : drives) {
    starts.insert({query.start.x, query.start.y, query.start.heading});
    const Goal& goal = query.goals.front();
    goals.insert({goal.point.x, goal.point.y, goal.heading.value()});
  }
  EXPECT_EQ(starts.size(), 24U);
  EXPECT_EQ(goals.size(), 24U);
  const auto again = random_drives(space, corners_of(space), 500, 3);
  for (std::size_t i = 0; i < drives.size(); ++i) EXPECT_EQ(drives[i].start, again[i].start);
  const FreeSpace walls = test::drawn_space("##\n");
  EXPECT_TRUE(random_drives(walls, corners_of(walls), 5, 1).empty());
  EXPECT_TRUE(random_drives(space, corners_of(space, 5), 5, 1).empty())
      << "no room for the lattice";
}

TEST(ComparisonRun, EndsAtTheClosestPlaceAndLeadsOut) {
  const FreeSpace space = test::drawn_space("#...#..");
  auto run = ComparisonRun::make(space, *parse_planner_specs("astar,bfs"), thread_cpu_seconds);
  ASSERT_TRUE(run);
  run->answer(CellPair{{0, 0}, {6, 0}});
  run->allow({.escape = 1, .closest = true});
  run->answer(CellPair{{0, 0}, {6, 0}});
  for (std::size_t planner = 0; planner < 2; ++planner) {
    EXPECT_FALSE(run->comparison().queries[0].rows[planner].found());
    const ComparisonRow& row = run->comparison().queries[1].rows[planner];
    ASSERT_TRUE(row.found()) << row.reason;
    EXPECT_EQ(row.remaining, 3);
    EXPECT_EQ(row.steps, 3U);
    EXPECT_EQ(row.notes.size(), 2U);
    EXPECT_EQ(run->path(planner, 1), Path({{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
  }
}

TEST(ComparisonRun, SaysOfEveryPlannerWhatItsPlanSays) {
  const FreeSpace space = test::drawn_space(
      "........\n"
      ".######.\n"
      "........\n");
  ComparisonRun run = run_of(space, "astar:w=2,bfs:connectivity=4,dfs");
  const std::array<CellPair, 2> queries{{{{0, 2}, {7, 0}}, {{3, 0}, {3, 2}}}};
  for (const CellPair& cells : queries) run.answer(cells);

  ASSERT_EQ(run.comparison().queries.size(), 2U);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    for (std::size_t planner = 0; planner < 3; ++planner) {
      const ComparisonRow& row = run.comparison().queries[i].rows[planner];
      const PlannerSpec& spec = run.planners()[planner];
      SCOPED_TRACE(spec.text);
      const auto alone = make_planner(spec.name, space, spec.options);
      const auto plan = (*alone)->plan(Query::between(queries[i].start, queries[i].goal));
      ASSERT_TRUE(plan && row.found());
      const PathMetrics metrics = *measure(plan->path, space);
      EXPECT_EQ(row.planner, spec.text);
      EXPECT_EQ(row.cost, plan->cost);
      EXPECT_EQ(row.length, metrics.length);
      EXPECT_NEAR(row.turning, degrees_from(metrics.turning), 1e-6);
      EXPECT_EQ(row.turning, 45 * std::round(row.turning / 45)) << "whole eighths of a turn";
      EXPECT_EQ(row.smallest_clearance, metrics.smallest_clearance);
      EXPECT_EQ(row.expanded, plan->metrics.expanded);
      EXPECT_EQ(row.generated, plan->metrics.generated);
      EXPECT_EQ(row.max_frontier, plan->metrics.max_frontier);
      EXPECT_EQ(row.times.preparation, 1) << "two looks at the clock";
      EXPECT_EQ(row.times.first, 1);
      EXPECT_EQ(row.times.later, 1);
      EXPECT_EQ(run.path(planner, i), plan->path);
      EXPECT_EQ(run.record(planner, i).expansions().size(), row.expanded);
    }
  }
}

TEST(ComparisonRun, RepeatsASearchThatWasStoppedAsFarAsItWent) {
  const FreeSpace space = test::open_space(30, 30);
  ComparisonRun run = run_of(space, "dijkstra");
  Limits limits;
  limits.expansions = 40;
  run.answer({{0, 0}, {29, 29}}, limits);
  const ComparisonRow& row = run.comparison().queries[0].rows[0];
  EXPECT_EQ(row.status, Status::expansion_limit);
  EXPECT_EQ(row.expanded, 40U);
  EXPECT_EQ(run.record(0, 0).expansions().size(), 40U);
  EXPECT_TRUE(run.path(0, 0).empty());
}

TEST(ComparisonRun, ComparesCars) {
  const FreeSpace space = test::drawn_space(
      "........\n"
      "........\n"
      "........\n"
      "...#....\n"
      "........\n"
      "........\n"
      "........\n"
      "........\n");
  ComparisonRun run = run_of(space, "car,car:unit=2");
  const Query query{{0, 0, 0}, {Goal(Point{8, 8})}};
  run.answer(query);
  EXPECT_TRUE(run.comparison().capabilities.headings);
  ASSERT_EQ(run.comparison().queries.size(), 1U);
  EXPECT_EQ(run.comparison().queries[0].start, query.start);
  for (std::size_t planner = 0; planner < 2; ++planner) {
    const ComparisonRow& row = run.comparison().queries[0].rows[planner];
    const PlannerSpec& spec = run.planners()[planner];
    SCOPED_TRACE(spec.text);
    const auto plan = (*make_planner(spec.name, space, spec.options))->plan(query);
    ASSERT_TRUE(plan && row.found());
    EXPECT_EQ(row.cost, plan->cost);
    EXPECT_NEAR(row.length, plan->cost * (planner == 0 ? 1 : 2), 1e-9)
        << "on even ground, in cells";
    EXPECT_EQ(row.steps, plan->moves.size());
    EXPECT_EQ(row.turning, 90 * std::round(row.turning / 90)) << "whole quarters of a turn";
    EXPECT_EQ(run.path(planner, 0), plan->path);
    const SearchRecorder recorder = run.record(planner, 0);
    EXPECT_EQ(recorder.expansions().size(), row.expanded);
    EXPECT_TRUE(recorder.snapshot().expanded[(Cell{0, 0})]);
  }
}

TEST(ComparisonRun, CountsHowOftenACarReverses) {
  const FreeSpace space = test::drawn_space("....\n");  // no room to turn except at its end
  ComparisonRun run = run_of(space, "car");
  run.answer(Query{{0, 0, 0}, {Pose{4, 0, 0}}});
  run.answer(Query{{4, 0, 0}, {Pose{0, 0, 0}}});
  run.answer(Query{{0, 0, 0}, {Pose{0, 0, kPi / 2}}});
  const auto& queries = run.comparison().queries;
  EXPECT_EQ(queries[0].rows[0].reversals, 0U);
  EXPECT_EQ(queries[0].rows[0].steps, 4U);
  EXPECT_EQ(queries[1].rows[0].reversals, 0U) << "in reverse all the way";
  const auto plan = (*make_planner("car", space))->plan(Query{{0, 0, 0}, {Pose{0, 0, kPi / 2}}});
  ASSERT_TRUE(plan);
  std::uint64_t changes = 0;
  for (std::size_t i = 1; i < plan->moves.size(); ++i) {
    changes += plan->moves[i].substr(0, 3) != plan->moves[i - 1].substr(0, 3) ? 1 : 0;
  }
  EXPECT_GT(changes, 0U);
  EXPECT_EQ(queries[2].rows[0].reversals, changes);
}

TEST(ComparisonRun, SaysWhyACarFindsNothing) {
  const FreeSpace space = test::drawn_space("..#..\n");
  ComparisonRun run = run_of(space, "car");
  run.answer(Query{{0, 0, 0}, {Pose{2, 0, 0}}});
  const ComparisonRow& row = run.comparison().queries[0].rows[0];
  EXPECT_EQ(row.status, Status::goal_blocked);
  EXPECT_NE(row.reason.find("obstacle"), std::string::npos) << row.reason;
  EXPECT_EQ(row.steps, 0U);
  EXPECT_TRUE(run.path(0, 0).empty());
}

TEST(ComparisonRun, RefusesToCompareCarsWithOthers) {
  const auto run = ComparisonRun::make(test::open_space(3, 3), *parse_planner_specs("astar,car"),
                                       ticking_clock());
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().status, Status::invalid_option);
}

TEST(ComparisonRun, RefusesOptionsThatThePlannerDoesNotTake) {
  const auto run = ComparisonRun::make(
      test::open_space(3, 3), *parse_planner_specs("bfs,astar:weight=-1"), ticking_clock());
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().status, Status::invalid_option);
  EXPECT_EQ(run.error().message,
            "astar:weight=-1: option 'weight': '-1' is not between 0 and 1e+06");
}

}  // namespace
}  // namespace wend
