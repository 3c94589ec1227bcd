#include "wend/planner/costs/cost_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/planner/costs/cost_oracle_test.hpp"

namespace wend {
namespace {

/// The cost of the way that the arrivals of a field lead back, in doubles.
template <class Field>
double cost_of_way(const Field& field, const FreeSpace& space, Cell cell) {
  double sum = 0;
  while (field.arrival(cell) != kNoMove) {
    const auto move = static_cast<Direction>(field.arrival(cell));
    const Cell before = step(cell, opposite(move));
    const double mean = (space.costs().multiplier(cell) + space.costs().multiplier(before)) / 2;
    sum += (static_cast<unsigned>(move) & 1U) != 0 ? std::numbers::sqrt2 * mean : mean;
    cell = before;
  }
  return sum;
}

template <class Number, class Word>
using DearField = CostField<Number, Word, CostUnits>;

/// All cells as the textbook has them, or an overflow, which is allowed if a cell costs about as much as a node can
/// hold.
template <class Number, class Word>
SearchOutcome expect_textbook(const FreeSpace& space, Cell goal) {
  const CostGrid<Word> grid(space, {});
  if (!DearField<Number, Word>::suits(grid)) return SearchOutcome::running;
  DearField<Number, Word> field(grid);
  const SearchOutcome outcome = field.run(std::array{goal}, {});
  const std::vector<std::uint64_t> truth = test::units_from(space, {}, goal);
  std::uint64_t most = 0;
  for (const std::uint64_t units : truth) {
    if (units != test::kNoUnits) most = std::max(most, units);
  }
  const std::uint64_t step = 2 * grid.most_steps() * CostUnits::kDiagonal;
  const std::uint64_t room = FieldNode<Number, CostUnits>::kMostCost;
  if (outcome == SearchOutcome::cost_overflow) {
    EXPECT_GT(most + 2 * step, room) << "the costs would fit";
    return outcome;
  }
  EXPECT_EQ(outcome, SearchOutcome::exhausted);
  EXPECT_LE(most, room);
  EXPECT_GT(field.bound(), most);
  for (const Cell cell : every_cell(space.map())) {
    const std::uint64_t units = truth[static_cast<std::size_t>(cell.y * space.width() + cell.x)];
    const bool reached = units != test::kNoUnits;
    EXPECT_EQ(field.reached(cell), reached);
    if (!reached) {
      EXPECT_EQ(field.cost(cell), std::numeric_limits<double>::infinity());
      EXPECT_EQ(field.arrival(cell), kNoMove);
    } else {
      EXPECT_EQ(field.units(cell), units) << cell.x << ',' << cell.y;
      const double cost = cost_of_way(field, space, cell);
      EXPECT_NEAR(field.cost(cell), cost, 1e-12 * (1 + cost));
    }
    if (::testing::Test::HasFailure()) break;
  }
  return outcome;
}

/// Every cell costs so much that some of these maps outgrow nodes of 64 bits.
FreeSpace random_dear_space(Random& random) {
  Grid<double> terrain(random.between(1, 40), random.between(1, 40), 1);
  const double scale = std::pow(10.0, random.between(2, 6));
  for (const Cell cell : every_cell(terrain)) terrain[cell] = scale * random.between(1, 9);
  const Grid<CellState> states(terrain.width(), terrain.height(), CellState::free);
  return *make_free_space(*make_grid_map(states, {}, terrain));
}

TEST(CostField, HasTheLeastUnitsOfAllCellsInNodesOfBothWidths) {
  int narrow = 0;
  int outgrown = 0;
  int held = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(600U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space =
        random.chance(0.2) ? random_dear_space(random) : test::random_cost_space(random);
    const Cell goal = test::random_cell_of(space, random);
    if (space.uniform_terrain() || !space.passable(goal)) continue;
    if (CostGrid<std::uint32_t>::holds(space.costs())) {
      expect_textbook<std::uint64_t, std::uint32_t>(space, goal);
      expect_textbook<WideFieldNumber, std::uint32_t>(space, goal);
      ++narrow;
    }
    const SearchOutcome outcome = expect_textbook<std::uint64_t, std::uint64_t>(space, goal);
    outgrown += outcome == SearchOutcome::cost_overflow ? 1 : 0;
    held += outcome == SearchOutcome::exhausted ? 1 : 0;
    const SearchOutcome wide = expect_textbook<WideFieldNumber, std::uint64_t>(space, goal);
    EXPECT_NE(wide, SearchOutcome::cost_overflow);
  }
  EXPECT_GT(narrow, test::share_of(100));
  EXPECT_GT(outgrown, test::share_of(20));
  EXPECT_GT(held, test::share_of(100));
}

}  // namespace
}  // namespace wend
