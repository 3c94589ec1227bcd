#include "wend/explore/explorer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

FreeSpaceOptions random_robot(Random& random) {
  FreeSpaceOptions robot;
  if (random.chance(0.4)) robot.footprint = Footprint::disc(2 * random.uniform());
  if (random.chance(0.3)) robot.clearance_distance = 3;
  if (random.chance(0.3)) robot.unknown = UnknownPolicy::free;
  return robot;
}

GridMap random_truth(Random& random) {
  const int width = random.between(5, 40);
  const int height = random.between(5, 40);
  const double blocked = 0.3 * random.uniform();
  Grid<CellState> states(width, height, CellState::free);
  Grid<double> terrain(width, height, 1);
  const bool costs = random.chance(0.3);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(blocked)) states[cell] = CellState::occupied;
    if (random.chance(0.02)) states[cell] = CellState::unknown;
    if (costs) terrain[cell] = random.between(1, 4);
  }
  return *make_grid_map(states, {}, terrain);
}

/// A robot reaches its goal if and only if a path leads there, by legal steps, whatever its planner, and
/// believes what is true of each cell that it has seen.
TEST(Explorer, ReachesWhatCanBeReached) {
  const std::vector<std::string> planners{"replanner", "d_star_lite", "astar", "dfs"};
  int arrived = 0;
  int failed = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(400U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const GridMap map = random_truth(random);
    ExplorerOptions options{.robot = random_robot(random)};
    options.sensor_range = 1 + 10 * random.uniform();
    options.planner.name = planners[seed % planners.size()];
    options.when = random.chance(0.5) ? ReplanWhen::path : ReplanWhen::discovery;
    options.keep = std::array{0.0, 0.3, 1.0}[seed % 3];
    const FreeSpace truth = *make_free_space(map, options.robot);
    const Cell start{random.between(0, map.width() - 1), random.between(0, map.height() - 1)};
    const Cell goal{random.between(0, map.width() - 1), random.between(0, map.height() - 1)};
    if (!truth.passable(start)) continue;
    auto explorer = Explorer::make(map, start, goal, options);
    ASSERT_TRUE(explorer) << explorer.error().message;
    std::optional<Status> end;
    while (!end) end = explorer->step();
    const bool reachable = truth.components().connected(start, goal, Adjacency::edges);
    ASSERT_EQ(*end == Status::found, reachable)
        << to_string(*end) << ": " << explorer->failure().message;
    ASSERT_TRUE(check_grid_path(truth, {}, explorer->driven()));
    ASSERT_EQ(explorer->driven().front(), start);
    (reachable ? arrived : failed) += 1;
    ASSERT_TRUE(!reachable || explorer->driven().back() == goal);
    for (const Cell cell : every_cell(map)) {
      const CellState believed = explorer->believed().map().state(cell);
      if (believed == CellState::unknown) continue;
      ASSERT_EQ(believed == CellState::occupied, truth.obstacles().blocked()[cell]);
    }
  }
  EXPECT_GT(arrived, test::share_of(100));
  EXPECT_GT(failed, test::share_of(20));
}

/// With keep = 1, a robot that plans after every discovery stays on its path as long as that is free.
TEST(Explorer, KeepsItsPathWhileItIsFree) {
  int kept = 0;
  int changed = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(60U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const GridMap map = random_truth(random);
    ExplorerOptions options{.sensor_range = 4, .when = ReplanWhen::discovery, .keep = 1};
    options.planner.name = seed % 2 == 0 ? "astar" : "dfs";
    const Cell goal{map.width() - 1, map.height() - 1};
    auto explorer = Explorer::make(map, {0, 0}, goal, options);
    if (!explorer) continue;
    std::optional<Status> end;
    while (!end) {
      const std::vector<Cell> before(explorer->ahead().begin(), explorer->ahead().end());
      end = explorer->step();
      if (!explorer->planned() || before.empty() || end) continue;
      const bool free = check_grid_path(explorer->believed(), {}, before).has_value();
      // The robot has also made a step, unless it felt that it could not.
      const std::span<const Cell> rest =
          std::span(before).last(std::min(before.size(), explorer->ahead().size()));
      const bool same = std::ranges::equal(rest, explorer->ahead());
      EXPECT_TRUE(!free || same);
      (same ? kept : changed) += 1;
    }
  }
  EXPECT_GT(kept, test::share_of(100));
  EXPECT_GT(changed, test::share_of(20));
}

/// Who knows the map drives a cheapest path and plans once.
TEST(Explorer, PlansOnceOnAMapThatItKnows) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const GridMap map = random_truth(random);
    ExplorerOptions options;
    options.robot.unknown = UnknownPolicy::free;
    options.known = map;
    const FreeSpace truth = *make_free_space(map, options.robot);
    const Cell start{0, 0};
    const Cell goal{map.width() - 1, map.height() - 1};
    const auto plan = (*make_planner("astar", truth))->plan(Query::between(start, goal));
    if (!plan) continue;
    auto explorer = Explorer::make(map, start, goal, options);
    ASSERT_TRUE(explorer);
    std::optional<Status> end;
    while (!end) end = explorer->step();
    EXPECT_EQ(*end, Status::found);
    EXPECT_EQ(explorer->totals().replans, 1U);
    EXPECT_NEAR(explorer->driven_cost(), plan->cost, 2e-6 * plan->cost);
  }
}

TEST(Explorer, SaysWhatIsWrong) {
  const GridMap map = test::drawn_map("....\n.#..\n....\n");
  const auto message = [&](Cell start, Cell goal, const ExplorerOptions& options) {
    const auto explorer = Explorer::make(map, start, goal, options);
    return explorer ? std::string() : explorer.error().message;
  };
  EXPECT_EQ(message({0, 0}, {9, 0}, {}), "the goal is outside the map");
  EXPECT_EQ(message({1, 1}, {0, 0}, {}), "the start is an obstacle");
  EXPECT_EQ(message({0, 0}, {3, 0}, {.sensor_range = 0.5}),
            "the range of the sensor must be at least 1 cell");
  EXPECT_EQ(message({0, 0}, {3, 0}, {.keep = -1}), "keep must be at least 0");
  EXPECT_EQ(message({0, 0}, {3, 0}, {.planner = {"theta_star"}}),
            "an explorer steps from cell to cell, which theta_star does not");
  EXPECT_EQ(message({0, 0}, {3, 0}, {.planner = {"replanner", {{"weight", "2"}}}}),
            "unknown option 'weight': choose from connectivity, corner_rule");
  EXPECT_EQ(message({0, 0}, {3, 0}, {.planner = {"astar", {{"connectivity", "5"}}}}),
            "option 'connectivity': '5' is not one of 4, 8");
  EXPECT_EQ(message({0, 0}, {3, 0}, {.known = test::drawn_map("..\n")}),
            "the known map has 2 x 1 cells, the true one 4 x 3");
}

}  // namespace
}  // namespace wend
