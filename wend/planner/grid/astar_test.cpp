// What A* and its options guarantee and do.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

constexpr std::string_view kUniform = "....\n....";
constexpr std::string_view kRough = "..5.\n....";

Plan plan_of(const FreeSpace& space, const Query& query, const OptionValues& options,
             std::string_view planner = "astar") {
  const auto made = make_planner(planner, space, options);
  if (!made) {
    ADD_FAILURE() << made.error().message;
    return {};
  }
  auto plan = (*made)->plan(query);
  EXPECT_TRUE(plan);
  return plan ? *std::move(plan) : Plan{};
}

double bound_of(std::string_view map, const OptionValues& options) {
  return plan_of(test::drawn_space(map), Query::between({0, 0}, {3, 1}), options).bound;
}

struct Claim {
  OptionValues options;
  double bound;
};

/// The result claims what its options allow it to claim, whatever the terrain.
TEST(AStar, ClaimsTheBoundThatItsOptionsAllow) {
  const std::vector<Claim> claims{
      {{}, 1},
      {{{"connectivity", "4"}}, 1},
      {{{"weight", "0"}}, 1},
      {{{"weight", "0.5"}}, 1},
      {{{"weight", "2.5"}}, 2.5},
      {{{"lambda", "3"}}, 3},
      {{{"w", "4"}}, 4},
      {{{"heuristic", "zero"}}, 1},
      {{{"heuristic", "constant"}, {"constant", "1000"}}, 1},
      {{{"heuristic", "constant"}, {"weight", "50"}}, 1},
      {{{"heuristic", "octile"}}, 1},
      {{{"heuristic", "euclidean"}, {"weight", "1.5"}}, 1.5},
      {{{"heuristic", "octile"}, {"connectivity", "4"}}, 1},
      {{{"heuristic", "manhattan"}, {"connectivity", "4"}}, 1},
      {{{"heuristic", "manhattan"}}, Plan::kNoBound},
      {{{"heuristic", "manhattan"}, {"weight", "2"}}, Plan::kNoBound},
      {{{"heuristic", "manhattan"}, {"weight", "0"}}, 1},
  };
  for (const Claim& claim : claims) {
    std::string text;
    for (const auto& [name, value] : claim.options) text += name + "=" + value + " ";
    EXPECT_EQ(bound_of(kUniform, claim.options), claim.bound) << text;
    EXPECT_EQ(bound_of(kRough, claim.options), claim.bound) << text << "on terrain";
  }
}

TEST(AStar, SaysOptimalWhereItIs) {
  const FreeSpace space = test::drawn_space(kUniform);
  const Query query = Query::between({0, 0}, {3, 1});
  EXPECT_TRUE(plan_of(space, query, {}).optimal());
  EXPECT_FALSE(plan_of(space, query, {{"weight", "2"}}).optimal());
  EXPECT_FALSE(plan_of(space, query, {{"heuristic", "manhattan"}}).optimal());
}

TEST(AStar, DefaultsToTheExactHeuristicOfItsConnectivity) {
  const FreeSpace space = test::open_space(30, 30);
  const Query query = Query::between({3, 5}, {25, 20});
  const auto metrics = [&](const OptionValues& options) {
    return plan_of(space, query, options).metrics;
  };
  EXPECT_EQ(metrics({}), metrics({{"heuristic", "octile"}}));
  EXPECT_EQ(metrics({}), metrics({{"heuristic", "auto"}}));
  EXPECT_EQ(metrics({{"connectivity", "4"}}),
            metrics({{"connectivity", "4"}, {"heuristic", "manhattan"}}));
  // With an exact estimate and ties to the larger g nothing but the path is expanded.
  EXPECT_EQ(metrics({}).expanded, 23U);
  EXPECT_EQ(metrics({{"connectivity", "4"}}).expanded, 38U);
}

TEST(AStar, WithoutWeightOrEstimateIsDijkstra) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const FreeSpace space = *make_free_space(test::random_map(random, 20, 20));
    const Cell start = test::random_cell(random, 20, 20);
    const Cell goal = test::random_cell(random, 20, 20);
    if (!space.components().connected(start, goal, Adjacency::edges)) continue;
    const Query query = Query::between(start, goal);
    const Plan dijkstra = plan_of(space, query, {}, "dijkstra");
    for (const OptionValues& options :
         {OptionValues{{"weight", "0"}}, OptionValues{{"heuristic", "zero"}},
          OptionValues{{"heuristic", "constant"}, {"constant", "12.5"}}}) {
      const Plan plan = plan_of(space, query, options);
      EXPECT_EQ(plan.path, dijkstra.path) << options.front().second;
      EXPECT_EQ(plan.metrics, dijkstra.metrics) << options.front().second;
    }
  }
}

/// However much the same is added everywhere: two goals, of which one is nearer by half a percent.
TEST(AStar, IsOptimalWithAnyConstantAndWeight) {
  Grid<double> terrain(21, 1, 1);
  for (int x = 10; x < 21; ++x) terrain[{x, 0}] = 1.005;
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(21, 1, CellState::free), {}, terrain));
  const Query query{pose_at({10, 0}), {pose_at({0, 0}), pose_at({20, 0})}};
  for (const char* constant : {"1e-9", "1e5", "1e9"}) {
    for (const char* weight : {"1", "1e6"}) {
      const Plan plan = plan_of(
          space, query, {{"heuristic", "constant"}, {"constant", constant}, {"weight", weight}});
      EXPECT_TRUE(plan.optimal());
      EXPECT_EQ(plan.path.cells().back(), (Cell{0, 0})) << constant << " times " << weight;
    }
  }
}

/// The better the estimate the fewer expansions; a weight saves more still.
TEST(AStar, ExpandsLessTheMoreItKnows) {
  const FreeSpace space = test::drawn_space(R"(
....................
....................
..........#.........
..........#.........
..........#.........
..........#.........
..........#.........
....................
....................
....................
)");
  const Query query = Query::between({2, 4}, {18, 4});
  const auto expanded = [&](const OptionValues& options) {
    return plan_of(space, query, options).metrics.expanded;
  };
  const auto zero = expanded({{"heuristic", "zero"}});
  const auto euclidean = expanded({{"heuristic", "euclidean"}});
  const auto octile = expanded({{"heuristic", "octile"}});
  const auto weighted = expanded({{"weight", "3"}});
  EXPECT_LT(euclidean, zero);
  EXPECT_LT(octile, euclidean);
  EXPECT_LT(weighted, octile);
}

/// Manhattan overestimates on 8 neighbours, and that can cost something.
TEST(AStar, IsNotOptimalWithManhattanOnEightNeighbours) {
  int worse = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const FreeSpace space = *make_free_space(test::random_map(random, 20, 20));
    const Cell start = test::random_cell(random, 20, 20);
    const Cell goal = test::random_cell(random, 20, 20);
    if (!space.components().connected(start, goal, Adjacency::edges)) continue;
    const Query query = Query::between(start, goal);
    const double optimum = plan_of(space, query, {}).cost;
    worse += plan_of(space, query, {{"heuristic", "manhattan"}}).cost > optimum + 1e-6 ? 1 : 0;
  }
  EXPECT_GT(worse, 0);
}

}  // namespace
}  // namespace wend
