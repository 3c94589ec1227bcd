#include "wend/map/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace wend {
namespace {

TEST(Grid, HasTheSameValueEverywhereAtFirst) {
  const Grid<int> grid(3, 2, 7);
  EXPECT_EQ(grid.width(), 3);
  EXPECT_EQ(grid.height(), 2);
  EXPECT_EQ(grid.size(), 6U);
  EXPECT_TRUE(std::all_of(grid.values().begin(), grid.values().end(),
                          [](int value) { return value == 7; }));
  EXPECT_EQ((Grid<int>(2, 2)[{1, 1}]), 0);
}

TEST(Grid, LiesRowByRowFromCellZero) {
  Grid<int> grid(3, 2);
  int number = 0;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) grid[{x, y}] = number++;
  }
  for (std::size_t i = 0; i < grid.size(); ++i) EXPECT_EQ(grid.values()[i], static_cast<int>(i));
  EXPECT_EQ(grid.row(1).size(), 3U);
  EXPECT_EQ(grid.row(1)[2], 5);
  grid.row(0)[1] = 42;
  EXPECT_EQ((grid[{1, 0}]), 42);
}

TEST(Grid, ContainsItsCellsAndNoOthers) {
  const Grid<int> grid(3, 2);
  EXPECT_TRUE(grid.contains({0, 0}));
  EXPECT_TRUE(grid.contains({2, 1}));
  for (const Cell outside : {Cell{-1, 0}, Cell{0, -1}, Cell{3, 0}, Cell{0, 2}}) {
    EXPECT_FALSE(grid.contains(outside)) << outside.x << "," << outside.y;
  }
}

TEST(Grid, WithoutCellsIsEmpty) {
  EXPECT_TRUE(Grid<int>().empty());
  EXPECT_FALSE(Grid<int>().contains({0, 0}));
  EXPECT_FALSE(Grid<int>(1, 1).empty());
}

TEST(Grid, IsEqualInShapeAndValues) {
  EXPECT_EQ(Grid<int>(3, 2, 1), Grid<int>(3, 2, 1));
  EXPECT_NE(Grid<int>(3, 2, 1), Grid<int>(2, 3, 1));
  EXPECT_NE(Grid<int>(3, 2, 1), Grid<int>(3, 2, 2));
}

}  // namespace
}  // namespace wend
