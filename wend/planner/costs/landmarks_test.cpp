#include "wend/planner/costs/landmarks.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "conformance/random_edit.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/costs/cost_oracle_test.hpp"
#include "wend/planner/planners.hpp"
#include "wend/space/grid/cost_units.hpp"

namespace wend {
namespace {

using NarrowGrid = CostGrid<std::uint32_t>;

/// No bound exceeds the cost, which a textbook Dijkstra finds; and between a landmark and another cell it is the
/// cost itself, so bounds say something.
TEST(Landmarks, BoundTheCostBetweenCells) {
  int exact = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(200U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = test::random_cost_space(random);
    if (space.uniform_terrain() || !NarrowGrid::holds(space.costs())) continue;
    const NarrowGrid grid(space, {});
    const auto landmarks = Landmarks::make(grid, 4);
    const Cell goal = test::random_cell_of(space, random);
    if (!space.passable(goal)) continue;
    const std::vector<std::uint64_t> truth = test::units_from(space, {}, goal);
    for (const Cell start : every_cell(space.map())) {
      const std::uint64_t cost = truth[static_cast<std::size_t>(start.y * space.width() + start.x)];
      if (cost == test::kNoUnits) continue;
      const Landmarks::Bounds bounds(landmarks, grid.number(start), grid.number(goal));
      ASSERT_LE(bounds(grid.number(start)), cost);
      exact += bounds(grid.number(start)) == cost && start != goal ? 1 : 0;
    }
  }
  EXPECT_GT(exact, test::share_of(500));
}

/// Bounds stay bounds while may_fall() says no.
TEST(Landmarks, StayBoundsWhileCostsOnlyRise) {
  int kept = 0;
  int fell = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(300U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    FreeSpace space = test::random_cost_space(random);
    if (space.uniform_terrain() || !NarrowGrid::holds(space.costs())) continue;
    NarrowGrid grid(space, {});
    const auto landmarks = Landmarks::make(grid, 4);
    const std::uint64_t position = grid.log_end();
    const auto change = space.edit(test::random_edit(random, space.map(), random.chance(0.5)));
    ASSERT_TRUE(change);
    if (change->everything || !grid.can_become(space)) continue;
    grid.repair(space, *change);
    const auto changes = grid.changes_since(position);
    if (!changes) continue;
    if (Landmarks::may_fall(grid, *changes)) {
      ++fell;
      continue;
    }
    ++kept;
    const Cell goal = test::random_cell_of(space, random);
    if (!space.passable(goal)) continue;
    const std::vector<std::uint64_t> truth = test::units_from(space, {}, goal);
    for (const Cell start : every_cell(space.map())) {
      const Landmarks::Bounds bounds(landmarks, grid.number(start), grid.number(goal));
      const std::uint64_t cost = truth[static_cast<std::size_t>(start.y * space.width() + start.x)];
      ASSERT_TRUE(cost == test::kNoUnits || bounds(grid.number(start)) <= cost);
    }
  }
  EXPECT_GT(kept, test::share_of(20));
  EXPECT_GT(fell, test::share_of(20));
}

}  // namespace
}  // namespace wend
