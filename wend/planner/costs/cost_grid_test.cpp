#include "wend/planner/costs/cost_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>

#include "conformance/random_edit.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/costs/cost_oracle_test.hpp"

namespace wend {
namespace {

using WideGrid = CostGrid<std::uint64_t>;

/// The definition of the class of a cell.
CostClass class_by_hand(const FreeSpace& space, Cell cell) {
  std::uint64_t least = ~std::uint64_t{0};
  std::uint64_t most = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Cell near{cell.x + dx, cell.y + dy};
      if (!space.passable(near)) continue;
      least = std::min<std::uint64_t>(least, space.costs().steps(near));
      most = std::max<std::uint64_t>(most, space.costs().steps(near));
    }
  }
  if (least == most) return CostClass::uniform;
  return 5 * most <= 9 * least ? CostClass::smooth : CostClass::general;
}

void expect_true_words(const WideGrid& grid, const FreeSpace& space) {
  const bool uniform = space.uniform_terrain();
  std::uint64_t least = ~std::uint64_t{0};
  for (const Cell cell : every_cell(space.map())) {
    const std::uint64_t word = grid.word(grid.number(cell));
    ASSERT_EQ(grid.cell(grid.number(cell)), cell);
    ASSERT_EQ(word != 0, space.passable(cell));
    if (word == 0) continue;
    ASSERT_EQ(WideGrid::steps(word), uniform ? 1 : space.costs().steps(cell));
    ASSERT_EQ(WideGrid::class_of(word), class_by_hand(space, cell)) << cell.x << ',' << cell.y;
    const unsigned block = space.passable().block(cell);
    ASSERT_EQ(WideGrid::key(word) & 255U, (block & 15U) | ((block >> 5U) << 4U));
    least = std::min(least, WideGrid::steps(word));
    ASSERT_LE(WideGrid::steps(word), grid.most_steps());
  }
  if (space.passable().count() > 0) {
    ASSERT_EQ(grid.least_steps(), least);
  }
}

FreeSpace random_wide_space(Random& random) {
  const int width = random.between(1, 200);
  const int height = random.between(1, 30);
  const double blocked = 0.5 * random.uniform();
  Grid<CellState> states(width, height, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(blocked)) states[cell] = CellState::occupied;
  }
  return *make_free_space(*make_grid_map(states));
}

/// After any sequence of edits the words are those of the edited map, and the log says which have changed.
TEST(CostGrid, IsRepairedToThatOfTheEditedMap) {
  int repairs = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(400U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    FreeSpace space =
        random.chance(0.5) ? random_wide_space(random) : test::random_cost_space(random);
    const bool terrain = !space.uniform_terrain();
    WideGrid grid(space, {});
    expect_true_words(grid, space);
    for (int i = 0; i < 6 && !HasFailure(); ++i) {
      const WideGrid before = grid;
      const auto change = space.edit(test::random_edit(random, space.map(), terrain));
      ASSERT_TRUE(change);
      if (change->everything || !grid.can_become(space)) break;
      grid.repair(space, *change);
      ++repairs;
      expect_true_words(grid, space);
      const auto changes = grid.changes_since(before.log_end());
      if (!changes) continue;
      std::size_t differ = 0;
      for (StateId id = 0; id < grid.state_count(); ++id)
        differ += grid.word(id) != before.word(id) ? 1 : 0;
      std::set<StateId> logged;
      for (const WideGrid::Change& each : *changes) {
        // The first entry of a cell has its word before all of them.
        ASSERT_TRUE(!logged.insert(each.id).second || each.before == before.word(each.id));
      }
      ASSERT_GE(logged.size(), differ);
      for (StateId id = 0; id < grid.state_count(); ++id) {
        ASSERT_TRUE(grid.word(id) == before.word(id) || logged.contains(id));
      }
    }
  }
  EXPECT_GT(repairs, test::share_of(800));
}

TEST(CostGrid, ForgetsALogThatHasBecomeLong) {
  FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(20, 20, CellState::free)));
  WideGrid grid(space, {});
  const std::uint64_t begin = grid.log_end();
  EXPECT_TRUE(grid.changes_since(begin)->empty());
  bool forgotten = false;
  for (int i = 0; i < 1000 && !forgotten; ++i) {
    const CellState state = i % 2 == 0 ? CellState::occupied : CellState::free;
    grid.repair(space, *space.edit({.corner = {5, 5}, .states = Grid<CellState>(9, 9, state)}));
    forgotten = !grid.changes_since(begin);
  }
  EXPECT_TRUE(forgotten);
  EXPECT_TRUE(grid.changes_since(grid.log_end()));
}

}  // namespace
}  // namespace wend
