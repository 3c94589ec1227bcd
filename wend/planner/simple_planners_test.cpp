// What bfs, dfs, greedy and dijkstra guarantee, each by itself.

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
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
  EXPECT_EQ(planners().names(), (std::vector<std::string>{"astar",
                                                          "dijkstra",
                                                          "alt",
                                                          "ara_star",
                                                          "jps",
                                                          "hub_labels",
                                                          "corner_hierarchy",
                                                          "any_angle",
                                                          "euclidean_labels",
                                                          "theta_star",
                                                          "lazy_theta_star",
                                                          "greedy",
                                                          "bfs",
                                                          "dfs",
                                                          "random_walk",
                                                          "replanner",
                                                          "d_star_lite",
                                                          "hybrid_astar",
                                                          "lattice",
                                                          "car"}));
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
