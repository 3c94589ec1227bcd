#include "bench/comparison/timed_planner.hpp"

#include <gtest/gtest.h>

#include "tests/testing/drawn_map.hpp"

namespace wend {
namespace {

PlannerSpec spec_of(std::string_view text) { return parse_planner_specs(text)->front(); }

FreeSpace ring() {
  return test::drawn_space(
      "........\n"
      ".######.\n"
      "........\n");
}

/// A clock that advances by `tick` at each reading.
Clock ticking_clock(double tick) {
  return [now = 0.0, tick]() mutable { return now += tick; };
}

TEST(TimedPlanner, AnswersAsThePlannerDoes) {
  TimedPlanner planner(ring(), spec_of("astar:w=2"), ticking_clock(1));
  ASSERT_FALSE(planner.error());
  Plan plan;
  QueryTimes times;
  EXPECT_EQ(planner.answer(Query::between({0, 2}, {7, 0}), plan, times), Status::found);
  EXPECT_EQ(plan.path.cells().front(), (Cell{0, 2}));
  EXPECT_EQ(plan.path.cells().back(), (Cell{7, 0}));
  EXPECT_EQ(planner.answer(Query::between({0, 2}, {3, 1}), plan, times), Status::goal_blocked);
}

TEST(TimedPlanner, TimesPreparationFirstAndLaterQueriesApart) {
  TimedPlanner planner(ring(), spec_of("jps"), ticking_clock(1));
  Plan plan;
  for (int query = 0; query < 3; ++query) {
    QueryTimes times;
    planner.answer(Query::between({0, 2}, {7, 0}), plan, times);
    EXPECT_EQ(times.preparation, 1) << "two looks at the clock";
    EXPECT_EQ(times.first, 1);
    EXPECT_EQ(times.later, 1) << "longer than the time to be filled: one run";
  }
}

TEST(TimedPlanner, BuildsAnIndexOnceAndCountsItAsPreparation) {
  const Clock clock = [now = 0.0, looks = 0]() mutable { return now += ++looks == 2 ? 100 : 1; };
  TimedPlanner planner(ring(), spec_of("hub_labels"), clock);
  ASSERT_FALSE(planner.error());
  Plan plan;
  for (int query = 0; query < 2; ++query) {
    QueryTimes times;
    EXPECT_EQ(planner.answer(Query::between({0, 2}, {7, 0}), plan, times), Status::found);
    EXPECT_EQ(times.preparation, 101) << "the index, and the planner on it";
  }
}

TEST(TimedPlanner, RepeatsLaterQueriesUntilTheTimeIsFilled) {
  double now = 0;
  Query query = Query::between({0, 2}, {7, 0});
  query.limits.clock = [&] { return now += 1e-3; };  // searches alone take time
  const FreeSpace space = ring();
  space.components();  // the first query would ask for them, and take longer than the others
  TimedPlanner planner(space, spec_of("bfs"), [&] { return now; }, {.fill_seconds = 20e-3});
  Plan plan;
  QueryTimes times;
  EXPECT_EQ(planner.answer(query, plan, times), Status::found);
  EXPECT_EQ(times.preparation, 0);
  EXPECT_GT(times.first, 0);
  EXPECT_NEAR(times.later, times.first, 1e-9);
  const double firsts = 2 * times.first;  // the first of all is not the one that counts
  EXPECT_GE(now, firsts + 20e-3 - 1e-9);
  EXPECT_LT(now, firsts + 20e-3 + times.later + 1e-9) << "and no more";
}

TEST(TimedPlanner, SaysWhyItCouldNotBeMade) {
  const TimedPlanner planner(ring(), spec_of("astar:weight=-1"), ticking_clock(1));
  ASSERT_TRUE(planner.error());
  EXPECT_EQ(planner.error()->status, Status::invalid_option);
  EXPECT_EQ(planner.planner(), nullptr);
}

}  // namespace
}  // namespace wend
