// ara_star: what its paths cost, against astar, and what its limits leave. conformance/anytime_checks.cpp holds its
// bounds against an independent search.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/anytime_work.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

struct AnytimeAnswer {
  Status status;
  Plan plan;
  std::vector<Plan> told;
};

AnytimeAnswer anytime_answer(Planner& planner, Query query) {
  AnytimeAnswer answer{Status::found, {}, {}};
  query.on_solution = [&](const Plan& plan) { answer.told.push_back(plan); };
  answer.status = planner.plan(query, answer.plan);
  return answer;
}

/// The start is in a pocket that opens away from the goal.
const FreeSpace& trap() {
  static const FreeSpace space = test::drawn_space(R"(
............................
............................
..###################.......
....................#.......
....................#.......
....................#.......
..###################.......
............................
............................
)");
  return space;
}

TEST(AraStar, FindsCheaperPathsUntilTheCheapest) {
  const auto planner = make_planner(trap(), AraStarOptions{.initial_weight = 20, .weight_step = 1});
  const auto optimum = make_planner(trap(), AStarOptions{});
  const Query query = Query::between({4, 4}, {26, 4});
  const AnytimeAnswer answer = anytime_answer(**planner, query);
  ASSERT_EQ(answer.status, Status::found);
  ASSERT_GT(answer.told.size(), 1U);
  EXPECT_TRUE(answer.plan.optimal());
  EXPECT_EQ(answer.told.back().path, answer.plan.path);
  EXPECT_NEAR(answer.plan.cost, (*optimum)->plan(query)->cost, 1e-9);
  EXPECT_GT(answer.told.front().bound, 1);
  EXPECT_LT(answer.told.front().metrics.expanded, answer.plan.metrics.expanded);
}

TEST(AraStar, WithAWeightOfOneIsAStar) {
  std::uint64_t expanded = 0;
  std::uint64_t expanded_by_astar = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const FreeSpace space = *make_free_space(test::random_map(random, 20, 20));
    const auto planner = make_planner(space, AraStarOptions{.initial_weight = 1});
    const auto astar = make_planner(space, AStarOptions{.leaps = false});
    const Query query =
        Query::between(test::random_cell(random, 20, 20), test::random_cell(random, 20, 20));
    const AnytimeAnswer answer = anytime_answer(**planner, query);
    Plan expected;
    EXPECT_EQ((*astar)->plan(query, expected), answer.status);
    if (answer.status != Status::found) continue;
    EXPECT_THAT(answer.told, SizeIs(1));
    EXPECT_NEAR(answer.plan.cost, expected.cost, 1e-9 * expected.cost);
    expanded += answer.plan.metrics.expanded;
    expanded_by_astar += expected.metrics.expanded;
  }
  // Its buckets are not sorted, but it leaps.
  EXPECT_LE(expanded, expanded_by_astar);
}

TEST(AraStar, AnswersAtATimeLimitWithItsBestPath) {
  const auto planner = make_planner(trap(), AraStarOptions{.initial_weight = 20, .weight_step = 1});
  Query query = Query::between({4, 4}, {26, 4});
  const AnytimeAnswer all = anytime_answer(**planner, query);
  double now = 0;
  query.limits.clock = [&] { return now; };
  query.limits.seconds = 1;
  // The clock strikes with the first path.
  Plan plan;
  query.on_solution = [&](const Plan&) { now = 2; };
  query.limits.expansions = all.told.front().metrics.expanded + 1;
  ASSERT_EQ((*planner)->plan(query, plan), Status::found);
  EXPECT_LE(plan.cost, all.told.front().cost);
  EXPECT_GT(plan.bound, 1);
  EXPECT_LE(plan.cost, plan.bound * all.plan.cost * (1 + 1e-9));
}

TEST(AraStar, HasNoAnswerBeforeItsFirstPath) {
  const auto planner = make_planner(trap(), AraStarOptions{});
  Query query = Query::between({4, 4}, {26, 4});
  query.limits.expansions = 3;
  const AnytimeAnswer answer = anytime_answer(**planner, query);
  EXPECT_EQ(answer.status, Status::expansion_limit);
  EXPECT_THAT(answer.told, IsEmpty());
  EXPECT_TRUE(answer.plan.path.empty());
}

TEST(AraStar, LeavesNoPathWhenItIsCancelled) {
  const auto planner = make_planner(trap(), AraStarOptions{.initial_weight = 20, .weight_step = 1});
  std::atomic<bool> cancel = false;
  Query query = Query::between({4, 4}, {26, 4});
  query.limits.cancel = &cancel;
  Plan plan;
  auto outcome = (*planner)->begin(query, plan);
  while (!outcome && plan.path.empty()) outcome = (*planner)->step(plan);
  ASSERT_FALSE(outcome) << "it goes on after its first path";
  EXPECT_LT(plan.cost, Plan::kNoBound);
  // The flag is read every kExpansionsBetweenClockReads expansions, and this map is small.
  cancel = true;
  outcome = (*planner)->begin(query, plan);
  while (!outcome) outcome = (*planner)->step(plan);
  EXPECT_EQ(*outcome, Status::cancelled);
  EXPECT_TRUE(plan.path.empty());
}

TEST(AraStar, TellsTheSameWhenItIsStepped) {
  const auto planner = make_planner(trap(), AraStarOptions{.initial_weight = 20, .weight_step = 1});
  Query query = Query::between({4, 4}, {26, 4});
  const AnytimeAnswer expected = anytime_answer(**planner, query);
  std::vector<double> bounds;
  query.on_solution = [&](const Plan& plan) { bounds.push_back(plan.bound); };
  Plan plan;
  auto outcome = (*planner)->begin(query, plan);
  while (!outcome) outcome = (*planner)->step(plan);
  ASSERT_EQ(*outcome, Status::found);
  std::vector<double> expected_bounds;
  for (const Plan& each : expected.told) expected_bounds.push_back(each.bound);
  EXPECT_EQ(bounds, expected_bounds);
  EXPECT_EQ(plan.path, expected.plan.path);
}

/// Any options with which it leaps or expands cell by cell.
AraStarOptions random_options(Random& random) {
  AraStarOptions options{.initial_weight = 1 + 5 * random.uniform(),
                         .weight_step = 0.01 + random.uniform()};
  if (random.chance(0.1)) options.initial_weight = 1e6;
  if (random.chance(0.3)) options.moves.connectivity = Connectivity::four;
  if (random.chance(0.3)) options.moves.corner_rule = CornerRule::one;
  options.leaps = random.chance(0.6);
  return options;
}

/// Every path of an answer costs at most its bound times the least cost, and is better than the one before.
void expect_true_bounds(const AnytimeAnswer& answer, double least, double slack) {
  ASSERT_EQ(answer.status, Status::found);
  ASSERT_FALSE(answer.told.empty());
  EXPECT_EQ(answer.told.back().path, answer.plan.path);
  for (std::size_t i = 0; i < answer.told.size(); ++i) {
    const Plan& plan = answer.told[i];
    EXPECT_GE(plan.cost, least * (1 - slack));
    EXPECT_LE(plan.cost, plan.bound * least * (1 + slack));
    if (i == 0) continue;
    EXPECT_LE(plan.cost, answer.told[i - 1].cost * (1 + slack));
    EXPECT_LT(plan.bound, answer.told[i - 1].bound);
  }
}

/// On maps that are larger than those of the conformance suite: rounds are repeated, and end early.
TEST(AraStar, ProvesItsBoundsOnLargerMaps) {
  constexpr double kRounding = 1e-9;
  constexpr double kSlackOfCosts = 2e-6;
  Random random(3);
  std::size_t told = 0;
  for (int i = 0; i < 60 && !HasFailure(); ++i) {
    SCOPED_TRACE("seed 3, trial " + std::to_string(i));
    const char* const kinds[] = {"random", "maze", "rooms", "office", "warehouse", "rough"};
    const auto map = make_map(kinds[i % 6], random.between(121, 180), random.between(121, 180), 1);
    ASSERT_TRUE(map);
    const double clearance = random.chance(0.5) ? 2 * map->frame().resolution : 0;
    const FreeSpace space = *make_free_space(*map, {.clearance_distance = clearance});
    const AraStarOptions options = random_options(random);
    const auto planner = make_planner(space, options);
    const auto dijkstra =
        make_planner(space, DijkstraOptions{.moves = options.moves, .leaps = false});
    const double slack = space.uniform_terrain() ? kRounding : kSlackOfCosts;
    for (int j = 0; j < 4; ++j) {
      Query query = Query::between(test::random_cell(random, space.width(), space.height()),
                                   test::random_cell(random, space.width(), space.height()));
      const auto optimum = (*dijkstra)->plan(query);
      const AnytimeAnswer answer = anytime_answer(**planner, query);
      EXPECT_EQ(answer.status == Status::found, optimum.has_value());
      if (!optimum) continue;
      expect_true_bounds(answer, optimum->cost, slack);
      EXPECT_LE(answer.told.front().bound, options.initial_weight * (1 + kRounding));
      EXPECT_TRUE(answer.plan.optimal());
      told += answer.told.size();
      query.limits.expansions = random.below(answer.plan.metrics.expanded + 1);
      const AnytimeAnswer limited = anytime_answer(**planner, query);
      EXPECT_LE(limited.plan.metrics.expanded, query.limits.expansions);
      if (limited.status == Status::expansion_limit) continue;
      expect_true_bounds(limited, optimum->cost, slack);
    }
  }
  EXPECT_GT(told, 100U);
}

TEST(OtherPlanners, TellTheirOnlyPath) {
  const auto planner = make_planner(trap(), AStarOptions{});
  const AnytimeAnswer answer = anytime_answer(**planner, Query::between({4, 4}, {26, 4}));
  ASSERT_THAT(answer.told, SizeIs(1));
  EXPECT_EQ(answer.told.front().path, answer.plan.path);
}

/// The expansions until the proof, over those of astar.
double work_beside_astar(const FreeSpace& space, std::uint64_t seed) {
  const auto planner = make_planner(space, AraStarOptions{});
  const auto astar = make_planner(space, AStarOptions{.leaps = false});
  Random random(seed);
  return test::anytime_work(**planner, **astar, 40, [&] {
    const Cell start = test::random_cell(random, space.width(), space.height());
    return Query::between(start, test::random_cell(random, space.width(), space.height()));
  });
}

TEST(AraStar, DoesAtMostTwoAndAHalfTimesTheWorkOfAStar) {
  double logarithms = 0;
  int maps = 0;
  for (const char* name : {"random", "maze", "rooms", "office", "warehouse", "rough"}) {
    const auto map = make_map(name, 121, 121, 1);
    ASSERT_TRUE(map) << name;
    const double work = work_beside_astar(*make_free_space(*map), 5);
    std::cout << name << ": " << work << " times the expansions of astar\n";
    logarithms += std::log(work);
    ++maps;
  }
  const double mean = std::exp(logarithms / maps);
  std::cout << "geometric mean " << mean << '\n';
  EXPECT_LE(mean, 2.5);
}

}  // namespace
}  // namespace wend
