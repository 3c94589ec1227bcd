#include "wend/planner/grid/leap_engine.hpp"

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
#include "wend/planner/goal_region.hpp"
#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

constexpr std::uint64_t kNoWay = std::numeric_limits<std::uint64_t>::max();

/// The cost of a step by the definition of CostUnits.
std::uint64_t step_units(const FreeSpace& space, Cell from, Cell to) {
  const std::uint64_t sum = std::uint64_t{space.costs().steps(from)} + space.costs().steps(to);
  return sum * (from.x != to.x && from.y != to.y ? 577 : 408);
}

std::uint64_t units_of(const FreeSpace& space, std::span<const Cell> path) {
  std::uint64_t sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += step_units(space, path[i - 1], path[i]);
  return sum;
}

bool is_legal(const FreeSpace& space, GridMoves moves, Cell from, Cell to) {
  if (from == to || !space.passable(to)) return false;
  if (from.x == to.x || from.y == to.y) return true;
  if (moves.connectivity == Connectivity::four) return false;
  const int blocked =
      (space.passable(Cell{from.x, to.y}) ? 0 : 1) + (space.passable(Cell{to.x, from.y}) ? 0 : 1);
  return blocked <= static_cast<int>(moves.corner_rule);
}

/// Textbook Dijkstra in whole numbers: the least units from a cell to each.
std::vector<std::uint64_t> units_from(const FreeSpace& space, GridMoves moves, Cell start) {
  const int width = space.width();
  const auto number = [width](Cell cell) {
    return static_cast<std::size_t>(cell.y * width + cell.x);
  };
  std::vector<std::uint64_t> least(space.map().size(), kNoWay);
  using Open = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  least[number(start)] = 0;
  open.emplace(0, number(start));
  while (!open.empty()) {
    const auto [g, at] = open.top();
    open.pop();
    if (g > least[at]) continue;
    const Cell from{static_cast<int>(at) % width, static_cast<int>(at) / width};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell to{from.x + dx, from.y + dy};
        if (!is_legal(space, moves, from, to)) continue;
        const std::uint64_t units = g + step_units(space, from, to);
        if (units >= least[number(to)]) continue;
        least[number(to)] = units;
        open.emplace(units, number(to));
      }
    }
  }
  return least;
}

enum class Ground { inflated, whole, nearly_even, spiky, rectangles, vast };

double multiplier_on(Ground ground, Random& random) {
  switch (ground) {
    case Ground::whole:
      return random.between(1, 3);
    case Ground::nearly_even:
      return 1 + random.uniform() / 2;
    case Ground::spiky:
      return random.chance(0.1) ? 1 + 100 * random.uniform() : 1;
    case Ground::vast:
      return random.chance(0.1) ? 1 + 1e6 * random.uniform() : 1;
    case Ground::inflated:
    case Ground::rectangles:
      break;
  }
  return 1;
}

void add_rectangles(Grid<double>& terrain, Random& random) {
  for (int left = random.between(1, 8); left > 0; --left) {
    const int x = random.between(0, terrain.width() - 1);
    const int y = random.between(0, terrain.height() - 1);
    const int width = random.between(1, 12);
    const int height = random.between(1, 12);
    const int rise = random.between(0, 4);
    const double multiplier = 1 + rise * (random.chance(0.5) ? 1 : 0.1);
    for (int j = y; j < std::min(y + height, terrain.height()); ++j) {
      for (int i = x; i < std::min(x + width, terrain.width()); ++i) terrain[{i, j}] = multiplier;
    }
  }
}

/// Walls three cells apart, with gaps, now and then.
void add_rooms(Grid<CellState>& states, Random& random) {
  for (int y = 0; y < states.height(); ++y) {
    for (int x = 0; x < states.width(); ++x) {
      const bool wall = x % 4 == 3 || y % 4 == 3;
      if (wall && !random.chance(0.3)) states[{x, y}] = CellState::occupied;
    }
  }
}

FreeSpace random_space(Random& random) {
  const int width = random.between(1, 40);
  const int height = random.between(1, 40);
  const auto ground = static_cast<Ground>(random.between(0, 5));
  const double blocked = random.chance(0.3) ? 0.02 : 0.35 * random.uniform();
  Grid<CellState> states(width, height, CellState::free);
  Grid<double> terrain(width, height, 1);
  for (const Cell cell : every_cell(terrain)) {
    if (random.chance(blocked)) states[cell] = CellState::occupied;
    terrain[cell] = multiplier_on(ground, random);
  }
  if (random.chance(0.2)) add_rooms(states, random);
  if (ground == Ground::rectangles) add_rectangles(terrain, random);
  FreeSpaceOptions options;
  if (ground == Ground::inflated) {
    options.clearance_distance = 5 * random.uniform();
    options.clearance_cost = random.chance(0.5) ? 4 : 30 * random.uniform();
  }
  return *make_free_space(*make_grid_map(states, {}, terrain), options);
}

BestFirst random_parts(Random& random) {
  const Connectivity connectivity = random.chance(0.2) ? Connectivity::four : Connectivity::eight;
  const int corners = random.chance(0.6) ? 0 : random.between(1, 2);
  const HeuristicKind kind =
      random.chance(0.3) ? HeuristicKind::zero : resolved(HeuristicKind::automatic, connectivity);
  return {{connectivity, static_cast<CornerRule>(corners)}, kind, 0, 1};
}

Cell random_cell_of(const FreeSpace& space, Random& random) {
  const int x = random.between(0, space.width() - 1);
  const int y = random.between(0, space.height() - 1);
  return {x, y};
}

/// Free goals, some with a tolerance, and what the cheapest of them costs.
struct DrawnGoals {
  std::vector<GoalRegion> regions;
  std::uint64_t least = kNoWay;
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
    const FreeSpace space = random_space(random);
    const BestFirst parts = random_parts(random);
    if (space.uniform_terrain() || !can_leap(space, parts)) continue;
    const auto engine = leap_parts(space, parts).engine;
    for (int query = 0; query < 4; ++query) {
      const Cell start = random_cell_of(space, random);
      if (!space.passable(start)) continue;
      const DrawnGoals goals = random_goals(space, units_from(space, parts.moves, start), random);
      if (goals.regions.empty()) continue;
      const Limits limits;
      engine->begin(start, goals.regions, limits, nullptr);
      const SearchOutcome outcome = engine->run();
      ASSERT_EQ(outcome == SearchOutcome::found, goals.least != kNoWay);
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
