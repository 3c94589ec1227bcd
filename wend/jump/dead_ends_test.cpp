#include "wend/jump/dead_ends.hpp"

#include <gtest/gtest.h>

#include <array>
#include <queue>
#include <string>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {
namespace {

BitGrid random_cells(Random& random) {
  const int width = random.between(1, 14);
  const int height = random.between(1, 14);
  const double share = 0.4 + 0.55 * random.uniform();
  BitGrid cells(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) cells.set({x, y}, random.chance(share));
  }
  return cells;
}

/// A maze of passages one or two cells wide, with many dead ends.
BitGrid random_maze(Random& random) {
  constexpr int kRooms = 6;
  const int unit = random.between(2, 3);
  BitGrid cells(kRooms * unit + 1, kRooms * unit + 1);
  for (int y = 0; y < kRooms; ++y) {
    for (int x = 0; x < kRooms; ++x) {
      const bool right = random.chance(0.6);
      for (int i = 1; i < unit; ++i) {
        for (int j = 1; j < unit; ++j) cells.set({x * unit + i, y * unit + j}, true);
        if (right && x + 1 < kRooms) cells.set({(x + 1) * unit, y * unit + i}, true);
        if (!right && y + 1 < kRooms) cells.set({x * unit + i, (y + 1) * unit}, true);
      }
    }
  }
  return cells;
}

/// By Dijkstra: the lengths of shortest paths from a cell, negative where no path exists.
std::vector<double> lengths_from(const BitGrid& cells, Cell start) {
  const auto number = [&](Cell cell) {
    return static_cast<std::size_t>(cell.y * cells.width() + cell.x);
  };
  std::vector<double> lengths(static_cast<std::size_t>(cells.width() * cells.height()), -1);
  using Open = std::pair<double, Cell>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  open.push({0, start});
  while (!open.empty()) {
    const auto [length, cell] = open.top();
    open.pop();
    if (lengths[number(cell)] >= 0) continue;
    lengths[number(cell)] = length;
    for (const Cell step : kDirectionSteps) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      if (!cells[next] || !cells[{next.x, cell.y}] || !cells[{cell.x, next.y}]) continue;
      open.push({length + (step.x != 0 && step.y != 0 ? 1.4142135623730951 : 1), next});
    }
  }
  return lengths;
}

/// No jump point that stays closed lies on any shortest path.
void expect_closed_ones_needless(const BitGrid& cells, Random& random, int& closed) {
  const auto boards = JumpBoards(cells);
  const auto dead_ends = std::make_shared<const DeadEnds>(boards);
  const BitLines jump_points = boards.jump_points();
  OpenDeadEnds open(dead_ends);
  const auto passable = [&] {
    for (int i = 0; i < 1000; ++i) {
      const int x = random.between(0, cells.width() - 1);
      const int y = random.between(0, cells.height() - 1);
      if (cells[{x, y}]) return Cell{x, y};
    }
    return Cell{-1, -1};
  };
  for (int i = 0; i < 5; ++i) {
    const Cell start = passable();
    const Cell goal = passable();
    if (start.x < 0) return;
    open.open_for(start, std::array{goal});
    const auto from_start = lengths_from(cells, start);
    const auto from_goal = lengths_from(cells, goal);
    const double shortest = from_start[static_cast<std::size_t>(goal.y * cells.width() + goal.x)];
    if (shortest < 0) continue;
    for (int y = 0; y < cells.height(); ++y) {
      for (int x = 0; x < cells.width(); ++x) {
        const auto number = static_cast<std::size_t>(y * cells.width() + x);
        if (!jump_points.get(y, x) || open.contains(open.number({x, y})) || from_start[number] < 0)
          continue;
        ++closed;
        EXPECT_GT(from_start[number] + from_goal[number], shortest + 1e-9)
            << start.x << ',' << start.y << " to " << goal.x << ',' << goal.y << " passes " << x
            << ',' << y;
      }
    }
  }
}

TEST(DeadEnds, ThatStayClosedLieOnNoShortestPath) {
  Random random(21);
  int closed = 0;
  for (int map = 0; map < test::share_of(1500) && !::testing::Test::HasFailure(); ++map) {
    SCOPED_TRACE("map " + std::to_string(map));
    expect_closed_ones_needless(map % 3 == 0 ? random_maze(random) : random_cells(random), random,
                                closed);
  }
  EXPECT_GT(closed, test::share_of(10000)) << "hardly anything was tested";
}

TEST(DeadEnds, AMazeWithoutLoopsIsOneBigDeadEnd) {
  // A comb: a corridor with teeth.
  BitGrid cells(21, 10);
  for (int x = 0; x < 21; ++x) cells.set({x, 9}, true);
  for (int x = 0; x < 21; x += 2) {
    for (int y = 0; y < 9; ++y) cells.set({x, y}, true);
  }
  const DeadEnds dead_ends{JumpBoards(cells)};
  EXPECT_GE(dead_ends.cells(), cells.count() - 21) << "all teeth at least";
}

TEST(DeadEnds, ARingHasNone) {
  BitGrid cells(9, 9);
  for (int i = 0; i < 9; ++i) {
    for (const Cell cell : {Cell{i, 0}, Cell{i, 8}, Cell{0, i}, Cell{8, i}}) cells.set(cell, true);
  }
  const DeadEnds dead_ends{JumpBoards(cells)};
  EXPECT_EQ(dead_ends.cells(), 0U);
  EXPECT_EQ(dead_ends.size(), 0U);
}

}  // namespace
}  // namespace wend
