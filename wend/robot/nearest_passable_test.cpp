#include "wend/robot/nearest_passable.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "tests/testing/share.hpp"
#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

FreeSpace random_space(Random& random) {
  const BitGrid blocked = test::random_odd_bits(random);
  Grid<CellState> states(blocked.width(), blocked.height(), CellState::free);
  for (const Cell cell : test::all_cells(blocked.width(), blocked.height())) {
    if (blocked[cell]) states[cell] = CellState::occupied;
  }
  return *make_free_space(*make_grid_map(states),
                          {.footprint = Footprint::disc(random.chance(0.5) ? 0.0 : 1.0)});
}

/// The first of all cells by distance, then row, then column.
std::optional<Cell> nearest_of_all(const FreeSpace& space, Cell from,
                                   std::optional<Cell> connected_to, Adjacency adjacency) {
  std::optional<Cell> nearest;
  const auto rank = [&](Cell cell) {
    const std::int64_t dx = std::int64_t{cell.x} - from.x;
    const std::int64_t dy = std::int64_t{cell.y} - from.y;
    return std::tuple(dx * dx + dy * dy, cell.y, cell.x);
  };
  for (const Cell cell : test::all_cells(space.width(), space.height())) {
    if (!space.passable(cell)) continue;
    if (connected_to && !space.components().connected(cell, *connected_to, adjacency)) continue;
    if (!nearest || rank(cell) < rank(*nearest)) nearest = cell;
  }
  return nearest;
}

std::string text_of(const std::optional<Cell>& cell) {
  return cell ? std::to_string(cell->x) + "," + std::to_string(cell->y) : "none";
}

void expect_nearest(const FreeSpace& space, Cell from, std::optional<Cell> connected_to,
                    Adjacency adjacency) {
  const auto found = nearest_passable(space, from, connected_to, adjacency);
  const auto expected = nearest_of_all(space, from, connected_to, adjacency);
  ASSERT_TRUE(found == expected) << "from " << from.x << "," << from.y << ": " << text_of(found)
                                 << " instead of " << text_of(expected);
}

TEST(NearestPassable, IsTheNearestOfAllCells) {
  for (std::uint64_t seed = 0; seed < test::share_of(300U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const FreeSpace space = random_space(random);
    for (int i = 0; i < 20; ++i) {
      const Cell from{random.between(-8, space.width() + 8),
                      random.between(-8, space.height() + 8)};
      expect_nearest(space, from, std::nullopt, Adjacency::edges);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(NearestPassable, IsConnectedToTheOtherEnd) {
  for (std::uint64_t seed = 0; seed < test::share_of(300U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const FreeSpace space = random_space(random);
    for (int i = 0; i < 20; ++i) {
      const Cell from{random.between(-8, space.width() + 8),
                      random.between(-8, space.height() + 8)};
      const Cell other{random.between(0, space.width() - 1), random.between(0, space.height() - 1)};
      expect_nearest(space, from, other, Adjacency::edges);
      expect_nearest(space, from, other, Adjacency::edges_and_corners);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(NearestPassable, IsThePassableCellItself) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(5, 4, CellState::free)));
  for (const Cell cell : test::all_cells(5, 4)) EXPECT_EQ(nearest_passable(space, cell), cell);
}

TEST(NearestPassable, IsInTheSmallerRowOfTwoAtTheSameDistance) {
  // (3, 4) away lies in a nearer square ring than (0, -5) does.
  Grid<CellState> states(10, 10, CellState::occupied);
  states[{8, 9}] = CellState::free;
  states[{5, 0}] = CellState::free;
  EXPECT_EQ(nearest_passable(*make_free_space(*make_grid_map(states)), {5, 5}), (Cell{5, 0}));
}

TEST(NearestPassable, IsFoundFromFarOutside) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(5, 4, CellState::free)));
  EXPECT_EQ(nearest_passable(space, {1000000000, 1000000000}), (Cell{4, 3}));
  EXPECT_EQ(nearest_passable(space, {-1000000000, 2}), (Cell{0, 2}));
  EXPECT_EQ(nearest_passable(space, {2, -1000000000}), (Cell{2, 0}));
}

TEST(NearestPassable, IsNoneWhereEverythingIsBlocked) {
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(5, 4, CellState::occupied)));
  EXPECT_EQ(nearest_passable(space, {2, 2}), std::nullopt);
  EXPECT_EQ(nearest_passable(space, {-100, 2}), std::nullopt);
}

TEST(NearestPassable, IsNoneWhereTheOtherEndIsBlocked) {
  Grid<CellState> states(5, 4, CellState::free);
  states[{4, 3}] = CellState::occupied;
  const FreeSpace space = *make_free_space(*make_grid_map(states));
  EXPECT_EQ(nearest_passable(space, {0, 0}, Cell{4, 3}), std::nullopt);
}

}  // namespace
}  // namespace wend
