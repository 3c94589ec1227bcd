#include "wend/planner/costs/leap_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <queue>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/planner/costs/cost_oracle_test.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

using test::kNoUnits;
using test::random_cell_of;
using test::random_cost_space;
using test::units_from;
using test::units_of;

BestFirst random_parts(Random& random) {
  const Connectivity connectivity = random.chance(0.2) ? Connectivity::four : Connectivity::eight;
  const int corners = random.chance(0.6) ? 0 : random.between(1, 2);
  const HeuristicKind kind =
      random.chance(0.3) ? HeuristicKind::zero : resolved(HeuristicKind::automatic, connectivity);
  return {{connectivity, static_cast<CornerRule>(corners)}, kind, 0, 1};
}

/// Free goals, some with a tolerance, and what the cheapest of them costs.
struct DrawnGoals {
  std::vector<GoalRegion> regions;
  std::uint64_t least = kNoUnits;
};

DrawnGoals random_goals(const FreeSpace& space, const std::vector<std::uint64_t>& least,
                        Random& random) {
  DrawnGoals goals;
  for (int left = random.chance(0.7) ? 1 : 3; left > 0; --left) {
    const Cell cell = random_cell_of(space, random);
    const double tolerance = random.chance(0.7) ? 0 : 4 * random.uniform();
    GoalRegion region(Goal(centre_of(cell), tolerance), cell, cells_of(space));
    if (!region.keep_if([&](Cell at) { return space.passable(at); })) continue;
    region.for_each([&](Cell at) {
      if (!space.passable(at)) return;
      goals.least =
          std::min(goals.least, least[static_cast<std::size_t>(at.y * space.width() + at.x)]);
    });
    goals.regions.push_back(region);
  }
  return goals;
}

/// On maps with costs of every kind, by any moves, to any goals: the path is legal, and none is cheaper.
TEST(LeapEngine, FindsACheapestPathInUnits) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(2000U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = random_cost_space(random);
    const BestFirst parts = random_parts(random);
    if (space.uniform_terrain() || !can_leap(space, parts)) continue;
    const auto engine = leap_parts(space, parts, random.chance(0.3) ? 4 : 0).engine;
    for (int query = 0; query < 4; ++query) {
      const Cell start = random_cell_of(space, random);
      if (!space.passable(start)) continue;
      const DrawnGoals goals = random_goals(space, units_from(space, parts.moves, start), random);
      if (goals.regions.empty()) continue;
      const Limits limits;
      engine->begin(start, goals.regions, limits, nullptr);
      const SearchOutcome outcome = engine->run();
      ASSERT_EQ(outcome == SearchOutcome::found, goals.least != kNoUnits);
      if (outcome != SearchOutcome::found) continue;
      Path path;
      engine->write_path(path);
      ASSERT_TRUE(check_grid_path(space, parts.moves, path.cells()));
      ASSERT_EQ(path.cells().front(), start);
      ASSERT_TRUE(any_contains(goals.regions, path.cells().back()));
      ASSERT_EQ(units_of(space, path.cells()), goals.least);
      ++found;
    }
  }
  EXPECT_GT(found, test::share_of(3000));
}

/// Costs that outgrow 32 bits: a corridor of the dearest cells that 22 bits hold.
TEST(LeapEngine, WidensWhereCostsOutgrow32Bits) {
  for (const double multiplier : {16'000.0, 1e6}) {
    const Grid<CellState> states(300, 3, CellState::free);
    Grid<double> terrain(300, 3, multiplier);
    terrain[{0, 0}] = 1;
    const FreeSpace space = *make_free_space(*make_grid_map(states, {}, terrain));
    const auto engine = leap_parts(space, {{}, HeuristicKind::octile, 0, 1}).engine;
    const GoalRegion goal(Cell{299, 2});
    const Limits limits;
    engine->begin({0, 0}, {&goal, 1}, limits, nullptr);
    ASSERT_EQ(engine->run(), SearchOutcome::found);
    Path path;
    engine->write_path(path);
    EXPECT_EQ(units_of(space, path.cells()), units_from(space, {}, {0, 0})[300 * 2 + 299]);
  }
}

TEST(LeapEngine, LeapsOverEvenGround) {
  Grid<double> terrain(200, 200, 1);
  terrain[{199, 0}] = 2;
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(200, 200, CellState::free), {}, terrain));
  const auto engine = leap_parts(space, {{}, HeuristicKind::octile, 0, 1}).engine;
  const GoalRegion goal(Cell{190, 150});
  const Limits limits;
  engine->begin({10, 100}, {&goal, 1}, limits, nullptr);
  ASSERT_EQ(engine->run(), SearchOutcome::found);
  EXPECT_LT(engine->metrics().expanded, 100U) << "cell by cell it is at least the 181 of the path";
}

/// The ratio of the two step lengths, in the header and in the whole numbers.
TEST(CostUnits, ExceedTheSquareRootOfTwoByLessThanTheyState) {
  const double ratio =
      static_cast<double>(CostUnits::kDiagonal) / static_cast<double>(CostUnits::kStraight);
  EXPECT_GE(ratio, std::numbers::sqrt2);
  EXPECT_LE(ratio, std::numbers::sqrt2 * (1 + CostUnits::kMostExcess));
  EXPECT_LE(CostUnits::kMostExcess, 1e-5);
}

}  // namespace
}  // namespace wend
