// What bfs, dfs, greedy and dijkstra guarantee, each by itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

Plan plan_of(std::string_view planner, const FreeSpace& space, Cell from, Cell to,
             const OptionValues& options = {}) {
  const auto made = make_planner(planner, space, options);
  if (!made) {
    ADD_FAILURE() << made.error().message;
    return {};
  }
  auto plan = (*made)->plan(Query::between(from, to));
  EXPECT_TRUE(plan) << to_string(plan.error().status);
  return plan ? *std::move(plan) : Plan{};
}

const FreeSpace& uniform() {
  static const FreeSpace space = test::open_space(5, 4);
  return space;
}

const FreeSpace& rough() {
  static const FreeSpace space = test::drawn_space(".....\n.999.\n.....");
  return space;
}

TEST(Bfs, IsOptimalWhereAllStepsCostTheSame) {
  const Plan plan = plan_of("bfs", uniform(), {0, 0}, {4, 3}, {{"connectivity", "4"}});
  EXPECT_TRUE(plan.optimal());
  EXPECT_EQ(plan.cost, 7);
}

TEST(Bfs, IsWithinSqrtTwoOnEightNeighbours) {
  EXPECT_EQ(plan_of("bfs", uniform(), {0, 0}, {4, 3}).bound, std::numbers::sqrt2);
}

TEST(Bfs, GuaranteesNothingAboutCostsOnTerrain) {
  EXPECT_EQ(plan_of("bfs", rough(), {0, 1}, {4, 1}).bound, Plan::kNoBound);
}

TEST(Bfs, TakesTheFewestStepsEvenThroughTheRough) {
  const Plan plan = plan_of("bfs", rough(), {0, 1}, {4, 1}, {{"connectivity", "4"}});
  EXPECT_EQ(plan.bound, Plan::kNoBound);
  EXPECT_EQ(plan.path.size(), 5U);
  EXPECT_EQ(plan.cost, 5 + 9 + 9 + 5);
}

bool may_step(const FreeSpace& space, Cell from, Cell to) {
  return space.passable(to) && space.passable({from.x, to.y}) && space.passable({to.x, from.y});
}

/// The least length of the paths with the fewest steps to each cell; infinite where there is none.
Grid<double> shortest_of_fewest_steps(const FreeSpace& space, Cell start) {
  Grid<double> lengths(space.width(), space.height(), HUGE_VAL);
  lengths[start] = 0;
  for (std::vector<Cell> level{start}; !level.empty();) {
    Grid<double> next(space.width(), space.height(), HUGE_VAL);
    for (const Cell from : level) {
      for (const Cell offset : kDirectionSteps) {
        const Cell to{from.x + offset.x, from.y + offset.y};
        if (!space.contains(to) || lengths[to] < HUGE_VAL || !may_step(space, from, to)) continue;
        const double length = from.x != to.x && from.y != to.y ? std::numbers::sqrt2 : 1;
        next[to] = std::min(next[to], lengths[from] + length);
      }
    }
    level.clear();
    for (const Cell cell : every_cell(next)) {
      if (next[cell] == HUGE_VAL) continue;
      lengths[cell] = next[cell];
      level.push_back(cell);
    }
  }
  return lengths;
}

TEST(Bfs, GoesStraightWhereItCan) {
  const FreeSpace space = test::open_space(10, 10);
  EXPECT_EQ(plan_of("bfs", space, {0, 0}, {7, 0}).cost, 7);
  EXPECT_EQ(plan_of("bfs", space, {5, 9}, {5, 1}).cost, 8);
}

TEST(Bfs, TakesAShortestOfThePathsWithTheFewestSteps) {
  int paths = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const FreeSpace space = *make_free_space(
        *make_grid_map(test::random_states(random, random.between(2, 20), random.between(2, 20))));
    const Cell start = test::random_cell(random, space.width(), space.height());
    const Cell goal = test::random_cell(random, space.width(), space.height());
    if (!space.passable(start) || !space.passable(goal)) continue;
    const double least = shortest_of_fewest_steps(space, start)[goal];
    if (least == HUGE_VAL) continue;
    ++paths;
    EXPECT_NEAR(plan_of("bfs", space, start, goal).cost, least, 1e-9);
  }
  EXPECT_GT(paths, 50);
}

TEST(Dfs, GuaranteesNothingAboutCosts) {
  EXPECT_EQ(plan_of("dfs", uniform(), {0, 0}, {4, 3}).bound, Plan::kNoBound);
}

/// Down first as a successor means down last as a choice: the last in is the first out.
TEST(Dfs, FollowsTheSuccessorThatCameLast) {
  const Plan plan = plan_of("dfs", test::open_space(3, 3), {1, 1}, {0, 2});
  EXPECT_EQ(plan.path.cells()[1], (Cell{0, 2})) << "down-left is the last direction";
}

TEST(Greedy, GuaranteesNothingAboutCosts) {
  for (const char* heuristic : {"auto", "zero", "constant", "manhattan", "octile", "euclidean"}) {
    const Plan plan = plan_of("greedy", uniform(), {0, 0}, {4, 3}, {{"heuristic", heuristic}});
    EXPECT_EQ(plan.bound, Plan::kNoBound) << heuristic;
  }
}

TEST(Greedy, IsSometimesWorseThanAStarAndNeverBetter) {
  int worse = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const FreeSpace space = *make_free_space(test::random_map(random, 20, 20));
    const Cell start = test::random_cell(random, 20, 20);
    const Cell goal = test::random_cell(random, 20, 20);
    if (!space.components().connected(start, goal, Adjacency::edges)) continue;
    const double optimum = plan_of("astar", space, start, goal).cost;
    const double cost = plan_of("greedy", space, start, goal).cost;
    EXPECT_GE(cost, optimum - 1e-9);
    worse += cost > optimum + 1e-6 ? 1 : 0;
  }
  EXPECT_GT(worse, 0);
}

/// Ties of h go to the larger g, then to the newest: with no estimate it goes depth first.
TEST(Greedy, WithoutAnEstimateGoesDeepFirst) {
  const FreeSpace space = test::open_space(9, 9);
  const Plan plan = plan_of("greedy", space, {0, 0}, {8, 8}, {{"heuristic", "zero"}});
  EXPECT_GT(plan.path.size(), 9U);
}

TEST(Dijkstra, IsOptimalOnTerrainToo) {
  const Plan plan = plan_of("dijkstra", rough(), {0, 1}, {4, 1});
  EXPECT_TRUE(plan.optimal());
  EXPECT_NEAR(plan.cost, 2 + 2 * std::numbers::sqrt2, 1e-9) << "around the rough";
}

TEST(Dijkstra, TakesTheNearestOfSeveralGoals) {
  const auto planner = make_planner("dijkstra", test::open_space(20, 1));
  const auto plan = (*planner)->plan({pose_at({8, 0}), {pose_at({0, 0}), pose_at({12, 0})}});
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->path.cells().back(), (Cell{12, 0}));
  EXPECT_EQ(plan->cost, 4);
}

TEST(Planners, AreListedInOrder) {
  EXPECT_EQ(planners().names(),
            (std::vector<std::string>{
                "astar", "dijkstra", "alt", "ara_star", "jps", "hub_labels", "any_angle",
                "euclidean_labels", "theta_star", "lazy_theta_star", "greedy", "bfs", "dfs",
                "random_walk", "replanner", "d_star_lite", "hybrid_astar", "lattice", "car"}));
}

TEST(Planners, AnUnknownNameGetsASuggestion) {
  const auto made = make_planner("astr", uniform());
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().status, Status::invalid_option);
  EXPECT_EQ(made.error().message, "there is no planner 'astr': did you mean 'astar'?");
}

TEST(Planners, OptionsOfOtherPlannersAreRefused) {
  EXPECT_FALSE(make_planner("bfs", uniform(), {{"weight", "1"}}));
  EXPECT_FALSE(make_planner("dijkstra", uniform(), {{"heuristic", "octile"}}));
  EXPECT_FALSE(make_planner("random_walk", uniform(), {{"connectivity", "4"}}));
}

}  // namespace
}  // namespace wend
