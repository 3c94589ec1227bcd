#include "wend/space/se2/coarse_size.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"
#include "wend/map/connected_components.hpp"

namespace wend {
namespace {

/// Are drivable cells of the square at (x, y) not connected within it?
bool falls_apart(const BitGrid& drivable, int x, int y, int size) {
  BitGrid square(size, size);
  std::optional<Cell> first;
  for (int i = 0; i < size * size; ++i) {
    const Cell cell{i % size, i / size};
    const Cell on_map{x + cell.x, y + cell.y};
    if (!drivable.contains(on_map) || !drivable[on_map]) continue;
    square.set(cell, true);
    first = first.value_or(cell);
  }
  const ConnectedComponents components(square);
  for (int i = 0; i < size * size; ++i) {
    const Cell cell{i % size, i / size};
    if (square[cell] && !components.connected(*first, cell, Adjacency::edges)) return true;
  }
  return false;
}

bool keeps_walls(const BitGrid& drivable, int size) {
  int open = 0;
  int apart = 0;
  for (int y = 0; y < drivable.height(); y += size) {
    for (int x = 0; x < drivable.width(); x += size) {
      bool any = false;
      for (int i = 0; i < size * size; ++i) {
        const Cell cell{x + i % size, y + i / size};
        any = any || (drivable.contains(cell) && drivable[cell]);
      }
      open += any ? 1 : 0;
      apart += falls_apart(drivable, x, y, size) ? 1 : 0;
    }
  }
  return 1000 * apart <= open;
}

FreeSpace space_of(const Grid<CellState>& states, Footprint footprint = {}) {
  return *make_free_space(*make_grid_map(states), {.footprint = footprint});
}

/// A map with boxes of at least this many cells a side; few corners of them come close to each other.
Grid<CellState> boxes(Random& random, int least) {
  Grid<CellState> states(random.between(30, 140), random.between(30, 140), CellState::free);
  const int count = random.between(0, 12);
  for (int i = 0; i < count; ++i) {
    const int x = random.between(0, states.width() - 1);
    const int y = random.between(0, states.height() - 1);
    const int right = std::min(states.width(), x + random.between(least, least + 6));
    const int top = std::min(states.height(), y + random.between(least, least + 6));
    for (int row = y; row < top; ++row) {
      for (int column = x; column < right; ++column) {
        states[{column, row}] = CellState::occupied;
      }
    }
  }
  return states;
}

TEST(CoarseSize, IsTheLargestOfWhichHardlyAnySquareFallsApart) {
  int large = 0;
  int small = 0;
  for (std::uint64_t seed = 0; seed < test::share_of(600U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = space_of(boxes(random, random.between(1, 8)));
    const double most = 1 + 7 * random.uniform();
    const BitGrid& drivable = space.possible();
    const int size = coarse_size(space, drivable, most);
    const int limit = static_cast<int>(std::lround(most));
    EXPECT_LE(size, limit);
    EXPECT_TRUE(size == 1 || keeps_walls(drivable, size));
    for (int larger = size + 1; larger <= limit; ++larger) {
      EXPECT_FALSE(keeps_walls(drivable, larger)) << larger;
    }
    (size == limit ? large : small) += 1;
  }
  EXPECT_GT(large, test::share_of(30));
  EXPECT_GT(small, test::share_of(30));
}

TEST(CoarseSize, FollowsTheRadiusOfTheRobotWhateverTheMap) {
  Random random(1);
  Grid<CellState> states(60, 60, CellState::free);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      if (random.chance(0.05)) states[{x, y}] = CellState::occupied;
    }
  }
  for (const double radius : {0.9, 1.5, 2.5, 4.5, 9.0}) {
    SCOPED_TRACE(radius);
    const FreeSpace space = space_of(states, Footprint::disc(radius));
    const double wall = 2 * radius + 1 - std::sqrt(2);
    EXPECT_GE(coarse_size(space, space.possible(), 20), std::floor(wall / std::sqrt(2)));
  }
}

/// A costmap that is inflated by the radius of the robot is planned in for a point.
TEST(CoarseSize, IsThatOfTheRobotForAPointInAMapInflatedByItsRadius) {
  const GridMap offices = *make_map("office", 120, 90, 3);
  const FreeSpace disc = *make_free_space(offices, {.footprint = Footprint::disc(0.44)});
  Grid<CellState> states(120, 90, CellState::free);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 120; ++x) {
      if (!disc.possible()[{x, y}]) states[{x, y}] = CellState::occupied;
    }
  }
  const FreeSpace point = space_of(states);
  EXPECT_GE(coarse_size(point, point.possible(), 6), coarse_size(disc, disc.possible(), 6));
}

TEST(CoarseSize, IsSmallAmongWallsOfOneCell) {
  const FreeSpace maze = *make_free_space(*make_map("maze", 101, 101, 5), {});
  EXPECT_LE(coarse_size(maze, maze.possible(), 6), 2);
}

}  // namespace
}  // namespace wend
