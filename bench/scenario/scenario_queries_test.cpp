#include "bench/scenario/scenario_queries.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "conformance/reference.hpp"
#include "wend/generate/generators.hpp"

namespace wend {
namespace {

using test::Reference;
using test::Robot;
using test::Rules;

GridMap generated(const std::string& kind, int size, const OptionValues& options = {}) {
  return *make_map(kind, size, size, 3, options);
}

/// Compares every query with brute force.
void check_queries(const GridMap& map, const FreeSpaceOptions& options, GridMoves moves,
                   const std::vector<ScenarioQuery>& queries) {
  const int corners = moves.corner_rule == CornerRule::none  ? 0
                      : moves.corner_rule == CornerRule::one ? 1
                                                             : 2;
  const Reference reference(map, test::robot_in_cells(options, map.frame()),
                            {moves.connectivity == Connectivity::eight, corners});
  int last = 0;
  for (const ScenarioQuery& query : queries) {
    const std::vector<double> costs = reference.costs_from(query.start);
    EXPECT_NEAR(costs[reference.number(query.goal)], query.length, 1e-8);
    EXPECT_EQ(query.bucket, static_cast<int>(query.length / 4));
    EXPECT_GE(query.bucket, last);
    EXPECT_NE(query.start, query.goal);
    last = query.bucket;
  }
}

std::map<int, int> sizes_of(const std::vector<ScenarioQuery>& queries) {
  std::map<int, int> sizes;
  for (const ScenarioQuery& query : queries) ++sizes[query.bucket];
  return sizes;
}

TEST(ScenarioQueries, FillTheFirstBucketsWithShortestPaths) {
  const GridMap map = generated("rooms", 64);
  const FreeSpace space = *make_free_space(map);
  const auto queries = scenario_queries(space, {}, {.seed = 1, .buckets = 10});
  ASSERT_TRUE(queries);
  check_queries(map, {}, {}, *queries);
  const auto sizes = sizes_of(*queries);
  EXPECT_EQ(sizes.size(), 10U);
  for (const auto& [bucket, size] : sizes) EXPECT_EQ(size, 10) << bucket;
  for (const ScenarioQuery& query : *queries) {
    EXPECT_EQ(query.map_width, 64);
    EXPECT_EQ(query.map_height, 64);
  }
}

TEST(ScenarioQueries, AreForTheRobotItsMovesAndTheTerrain) {
  struct Case {
    GridMap map;
    FreeSpaceOptions options;
    GridMoves moves;
  };
  const std::vector<Case> cases{
      {generated("rough", 40), {}, {}},
      {generated("office", 80), {.footprint = Footprint::disc(0.2)}, {}},
      {generated("office", 80), {.unknown = UnknownPolicy::free}, {}},
      {generated("random", 40, {{"density", "0.3"}}), {}, {Connectivity::four, CornerRule::none}},
      {generated("random", 40, {{"density", "0.3"}}), {}, {Connectivity::eight, CornerRule::both}}};
  for (const Case& one : cases) {
    const auto queries =
        scenario_queries(*make_free_space(one.map, one.options), one.moves, {.per_bucket = 2});
    ASSERT_TRUE(queries);
    EXPECT_GT(queries->size(), 8U);
    check_queries(one.map, one.options, one.moves, *queries);
  }
}

TEST(ScenarioQueries, WithoutALimitReachTheLongestPaths) {
  const GridMap map = generated("maze", 31);
  const auto queries = scenario_queries(*make_free_space(map), {}, {.per_bucket = 10});
  ASSERT_TRUE(queries);
  double longest = 0;
  const Reference reference(map, Robot{}, Rules{});
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      for (const double cost : reference.costs_from({x, y})) {
        if (std::isfinite(cost)) longest = std::max(longest, cost);
      }
    }
  }
  EXPECT_GT(queries->back().length, 0.8 * longest);
  EXPECT_LE(queries->back().length, longest + 1e-8);
}

TEST(ScenarioQueries, FollowTheSeed) {
  const FreeSpace space = *make_free_space(generated("rooms", 64));
  const auto starts = [&](std::uint64_t seed) {
    std::vector<Cell> cells;
    const auto queries = scenario_queries(space, {}, {.seed = seed, .buckets = 5});
    for (const ScenarioQuery& query : *queries) cells.push_back(query.start);
    return cells;
  };
  EXPECT_EQ(starts(1), starts(1));
  EXPECT_NE(starts(1), starts(2));
}

TEST(ScenarioQueries, AreNeverTheSameTwiceOnATinyMap) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(2, 2, CellState::free)));
  const auto queries = scenario_queries(space, {}, {});
  ASSERT_TRUE(queries);
  std::set<std::vector<int>> pairs;
  for (const ScenarioQuery& query : *queries) {
    EXPECT_TRUE(pairs.insert({query.start.x, query.start.y, query.goal.x, query.goal.y}).second);
  }
  EXPECT_GT(pairs.size(), 4U);
  EXPECT_LE(pairs.size(), 10U);
}

TEST(ScenarioQueries, AreNoneWhereNothingIsConnected) {
  const auto none = [](const GridMap& map) {
    const auto queries = scenario_queries(*make_free_space(map), {}, {});
    return queries && queries->empty();
  };
  EXPECT_TRUE(none(*make_grid_map(Grid<CellState>(3, 3, CellState::occupied))));
  EXPECT_TRUE(none(*make_grid_map(Grid<CellState>(1, 1, CellState::free))));
}

TEST(ScenarioQueries, EndWhenTheyAreCancelled) {
  const std::atomic<bool> cancel = true;
  Limits limits;
  limits.cancel = &cancel;
  const auto queries = scenario_queries(*make_free_space(generated("rooms", 64)), {}, {}, limits);
  ASSERT_FALSE(queries);
  EXPECT_EQ(queries.error(), Status::cancelled);
}

}  // namespace
}  // namespace wend
