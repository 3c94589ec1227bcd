// any_angle against an independent search on all lines between corners, in whole numbers.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/visibility.hpp"
#include "wend/base/random.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;

constexpr double kRelative = 1e-9;

bool is_wrong(const Planner& planner, const test::Visibility& visibility, Cell start, Cell goal,
              double length, Status status, const Plan& plan) {
  if (status != Status::found) return std::isfinite(length);
  if (!(std::abs(plan.cost - length) <= kRelative * (1 + length))) return true;
  if (!visibility.fault(plan.path.waypoints(), start, goal).empty()) return true;
  return plan.bound != 1 || plan.cost != plan.path.length() ||
         planner.grid_moves()->connectivity != Connectivity::eight;
}

/// All pairs of cells, or from some of them to all others. The number of queries.
int expect_shortest(const BitGrid& free, CornerRule rule, int starts, std::uint64_t seed) {
  Grid<CellState> states(free.width(), free.height(), CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (!free[cell]) states[cell] = CellState::occupied;
  }
  const FreeSpace space = *make_free_space(*make_grid_map(states));
  const auto planner = make_planner(space, ShortestAnyAngleOptions{.corner_rule = rule});
  test::Visibility visibility(
      free.width(), free.height(), [&](Cell cell) { return free[cell]; }, rule == CornerRule::both);
  visibility.join_corners();
  Random random(seed);
  int queries = 0;
  Plan plan;
  const auto from = [&](Cell start) {
    if (!free[start]) return;
    const std::vector<double> lengths = visibility.lengths_from(start);
    for (const Cell goal : every_cell(states)) {
      if (!free[goal]) continue;
      const Status status = (*planner)->plan(Query::between(start, goal), plan);
      const double length = lengths[visibility.number(goal.x, goal.y)];
      ++queries;
      if (!is_wrong(**planner, visibility, start, goal, length, status, plan)) continue;
      ADD_FAILURE() << "from " << start.x << ',' << start.y << " to " << goal.x << ',' << goal.y
                    << ": " << to_string(status) << ", cost " << plan.cost << ", expected "
                    << length << ' ' << visibility.fault(plan.path.waypoints(), start, goal)
                    << " seed " << seed << '\n'
                    << test::drawing_of(space.map());
      return;
    }
  };
  if (starts == 0) {
    for (const Cell start : every_cell(states)) from(start);
  } else {
    for (int i = 0; i < starts; ++i) {
      const Cell start = test::random_cell(random, free.width(), free.height());
      from(start);
    }
  }
  return queries;
}

/// Cells [0, width) x [0, height), of which bit x + y width is set where they are free.
BitGrid cells_of(int width, int height, std::uint64_t bits) {
  BitGrid cells(width, height);
  for (int i = 0; i < width * height; ++i) {
    cells.set({i % width, i / width}, ((bits >> static_cast<unsigned>(i)) & 1U) != 0);
  }
  return cells;
}

BitGrid random_free(Random& random, int longest) {
  const int width = random.between(1, longest);
  const int height = random.between(1, longest);
  BitGrid cells(width, height);
  const double share = 0.4 + 0.6 * random.uniform();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool is_free = random.chance(share);
      cells.set({x, y}, is_free);
    }
  }
  return cells;
}

CornerRule random_rule(Random& random) {
  const int number = random.between(0, 3);
  return number == 0 ? CornerRule::none : number == 1 ? CornerRule::one : CornerRule::both;
}

int expect_shortest_on_random_maps(std::uint64_t first, std::uint64_t count) {
  int queries = 0;
  for (std::uint64_t seed = first; seed < first + count && !::testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    const int longest = seed % 10 == 0 ? 14 : 7;
    const BitGrid free = random_free(random, longest);
    const CornerRule rule = random_rule(random);
    queries += expect_shortest(free, rule, 2, seed);
  }
  return queries;
}

TEST(ShortestAnyAngle, IsShortestOnRandomMaps) {
  EXPECT_GT(expect_shortest_on_random_maps(1, 3000), 20'000);
}

TEST(ShortestAnyAngle, IsShortestOnAHundredThousandRandomMapsLongRun) {
  EXPECT_GT(expect_shortest_on_random_maps(10'000, 100'000), 1'000'000);
}

TEST(ShortestAnyAngle, IsShortestOnAllMapsOfNineCells) {
  for (std::uint64_t bits = 0; bits < 512 && !HasFailure(); ++bits) {
    expect_shortest(cells_of(3, 3, bits), CornerRule::none, 0, 1);
    expect_shortest(cells_of(3, 3, bits), CornerRule::both, 0, 1);
  }
}

TEST(ShortestAnyAngle, IsShortestOnAllMapsOfSixteenCellsLongRun) {
  for (std::uint64_t bits = 0; bits < 65536 && !HasFailure(); ++bits) {
    expect_shortest(cells_of(4, 4, bits), CornerRule::none, 0, 1);
    expect_shortest(cells_of(4, 4, bits), CornerRule::both, 0, 1);
  }
}

}  // namespace
}  // namespace wend
