#include "wend/generate/kept_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "conformance/random_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {
namespace {

int blocked(const GridMap& map, Cell cell) { return map.state(cell) == CellState::free ? 0 : 1; }

/// The least number of cells that are not free on a way between two, by relaxing until nothing changes.
int fewest_blocked(const GridMap& map, Cell from, Cell to) {
  constexpr int kFar = 1 << 20;
  Grid<int> least(map.width(), map.height(), kFar);
  least[from] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Cell cell : every_cell(least)) {
      for (const Cell beside : {Cell{cell.x + 1, cell.y}, Cell{cell.x - 1, cell.y},
                                Cell{cell.x, cell.y + 1}, Cell{cell.x, cell.y - 1}}) {
        if (!map.contains(beside)) continue;
        const int through = least[beside] + blocked(map, cell);
        if (through >= least[cell]) continue;
        least[cell] = through;
        changed = true;
      }
    }
  }
  return least[to];
}

TEST(KeptCells, AreJoinedByAsFewMoreAsPossible) {
  int opened = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(300U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const GridMap map =
        *make_grid_map(test::random_states(random, random.between(1, 14), random.between(1, 14)));
    const Cell from{random.between(0, map.width() - 1), random.between(0, map.height() - 1)};
    const Cell to{random.between(0, map.width() - 1), random.between(0, map.height() - 1)};
    const auto kept = keep_cells(map, {from, to});
    ASSERT_TRUE(kept);
    GridMap freed = map;
    ASSERT_TRUE(freed.edit({.cells = {{from, CellState::free}, {to, CellState::free}}}));
    EXPECT_EQ(kept->opened.size(), static_cast<std::size_t>(fewest_blocked(freed, from, to)));
    const FreeSpace space = *make_free_space(kept->map);
    EXPECT_TRUE(space.components().connected(from, to, Adjacency::edges));
    for (const Cell cell : kept->opened) {
      EXPECT_NE(freed.state(cell), CellState::free);
      ASSERT_TRUE(freed.edit({.cells = {{cell, CellState::free}}}));
    }
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        EXPECT_EQ(kept->map.state({x, y}), freed.state({x, y})) << "nothing else changes";
      }
    }
    opened += kept->opened.empty() ? 0 : 1;
  }
  EXPECT_GT(opened, test::share_of(50));
}

TEST(KeptCells, AreAllJoined) {
  for (std::uint64_t seed = 1; seed <= test::share_of(100U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const GridMap map = *make_grid_map(test::random_states(random, 20, 12));
    std::vector<Cell> cells;
    for (int i = random.between(1, 6); i > 0; --i) {
      cells.push_back({random.between(0, map.width() - 1), random.between(0, map.height() - 1)});
    }
    const auto kept = keep_cells(map, cells);
    ASSERT_TRUE(kept);
    const FreeSpace space = *make_free_space(kept->map);
    for (const Cell cell : cells) {
      EXPECT_TRUE(space.components().connected(cells.front(), cell, Adjacency::edges));
    }
    EXPECT_TRUE(keep_cells(kept->map, cells)->opened.empty());
  }
}

}  // namespace
}  // namespace wend
