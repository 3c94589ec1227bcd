#include "wend/jump/jump_boards.hpp"

#include <gtest/gtest.h>

#include <string>

#include "wend/base/random.hpp"

namespace wend {
namespace {

bool passable(const BitGrid& cells, Cell cell) { return cells.contains(cell) && cells[cell]; }

/// The same question, step by step: diagonally while both coordinates differ.
bool walks(const BitGrid& cells, Cell from, Cell to) {
  while (from != to) {
    const Cell step{(to.x > from.x) - (to.x < from.x), (to.y > from.y) - (to.y < from.y)};
    const Cell next{from.x + step.x, from.y + step.y};
    if (!passable(cells, next) || !passable(cells, {next.x, from.y}) ||
        !passable(cells, {from.x, next.y})) {
      return false;
    }
    from = next;
  }
  return true;
}

BitGrid random_cells(Random& random, int longest) {
  BitGrid cells(random.between(1, longest), random.between(1, longest));
  const double share = random.uniform();
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) cells.set({x, y}, random.chance(share));
  }
  return cells;
}

Cell random_cell(Random& random, const BitGrid& cells) {
  const int x = random.between(0, cells.width() - 1);
  return {x, random.between(0, cells.height() - 1)};
}

TEST(Sight, IsTheWayWithTheDiagonalStepsFirst) {
  Random random(12);
  int seen = 0;
  for (int map = 0; map < 1000 && !::testing::Test::HasFailure(); ++map) {
    const BitGrid cells = random_cells(random, map % 4 == 0 ? 150 : 12);
    const Sight sight(cells);
    for (int i = 0; i < 200; ++i) {
      const Cell from = random_cell(random, cells);
      const Cell to = random_cell(random, cells);
      if (!cells[from]) continue;
      const bool expected = cells[to] && walks(cells, from, to);
      seen += expected ? 1 : 0;
      EXPECT_EQ(sight.sees(from, to), expected)
          << "map " << map << ": " << from.x << ',' << from.y << " to " << to.x << ',' << to.y;
    }
  }
  EXPECT_GT(seen, 1000);
}

}  // namespace
}  // namespace wend
