// What keeping away from obstacles does to paths.

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

Plan cheapest(const FreeSpace& space, Cell start, Cell goal) {
  auto plan = (*make_planner("astar", space))->plan(Query::between(start, goal));
  EXPECT_TRUE(plan);
  return plan ? *std::move(plan) : Plan{};
}

double mean_clearance(const FreeSpace& space, const Path& path) {
  double sum = 0;
  for (const Cell cell : path.cells()) sum += space.clearance(cell);
  return sum / static_cast<double>(path.size());
}

/// Averages over paths between random cells that are connected.
struct Averages {
  double clearance = 0;
  double length = 0;
};

Averages averages(const GridMap& map, const FreeSpaceOptions& options, std::uint64_t seed) {
  constexpr int kPaths = 20;
  const FreeSpace space = *make_free_space(map, options);
  Random random(seed);
  Averages sums;
  for (int found = 0; found < kPaths;) {
    const Cell start = test::random_cell(random, map.width(), map.height());
    const Cell goal = test::random_cell(random, map.width(), map.height());
    if (start == goal || !space.components().connected(start, goal, Adjacency::edges)) continue;
    const Plan plan = cheapest(space, start, goal);
    sums.clearance += mean_clearance(space, plan.path) / kPaths;
    sums.length += plan.path.length() / kPaths;
    ++found;
  }
  return sums;
}

/// The more it costs, and the farther it reaches, the farther away paths are on average, and the
/// longer they get.
void expect_wider_paths(const GridMap& map, double radius, double distance, std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Averages before = averages(map, {.footprint = Footprint::disc(radius)}, seed);
  for (const double cost : {0.5, 4.0, 20.0}) {
    SCOPED_TRACE(cost);
    const Averages now = averages(map,
                                  {.footprint = Footprint::disc(radius),
                                   .clearance_distance = distance,
                                   .clearance_cost = cost},
                                  seed);
    EXPECT_GT(now.clearance, before.clearance);
    EXPECT_GE(now.length, before.length);
    before = now;
  }
}

TEST(ClearanceCost, MakesPathsWiderInOffices) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto map = make_map("office", 160, 100, seed);
    ASSERT_TRUE(map);
    expect_wider_paths(*map, 0.2, 0.6, seed);
  }
}

TEST(ClearanceCost, MakesPathsWiderInRooms) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto map = make_map("rooms", 120, 90, seed);
    ASSERT_TRUE(map);
    expect_wider_paths(*map, 0, 4, seed);
  }
}

TEST(ClearanceCost, StillPassesWhereThereIsNoOtherWay) {
  const FreeSpace space = test::drawn_space("...#...\n.......\n...#...",
                                            {.clearance_distance = 5, .clearance_cost = 1000});
  EXPECT_EQ(cheapest(space, {0, 1}, {6, 1}).path.size(), 7U);
}

TEST(ClearanceCost, TakesAWayRoundWhereOneIsWider) {
  const std::string_view map = R"(
.......
.......
.......
...#...
.......
...#...
)";
  const auto row_in_the_middle = [&](FreeSpaceOptions options) {
    const Path path = cheapest(test::drawn_space(map, options), {0, 4}, {6, 4}).path;
    for (const Cell cell : path.cells()) {
      if (cell.x == 3) return cell.y;
    }
    return -1;
  };
  EXPECT_EQ(row_in_the_middle({}), 4);
  EXPECT_LT(row_in_the_middle({.clearance_distance = 2, .clearance_cost = 10}), 3);
}

}  // namespace
}  // namespace wend
