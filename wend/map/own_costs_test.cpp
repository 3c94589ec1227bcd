#include "wend/map/own_costs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace wend {
namespace {

GridMap corridor() {
  Grid<CellState> cells(4, 2, CellState::free);
  cells[{2, 0}] = CellState::occupied;
  cells[{3, 1}] = CellState::unknown;
  return *make_grid_map(cells, {.resolution = 0.5, .origin = {1, 2, 0}, .metric = true},
                        Grid<double>(4, 2, 3));
}

TEST(OwnCosts, ComeFromAFunctionThatIsCalledOnceForEachCell) {
  const GridMap map = corridor();
  std::vector<Cell> called;
  const auto made = with_terrain(map, [&](Cell cell) {
    called.push_back(cell);
    return 1 + cell.x + 10.0 * cell.y;
  });
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(called.size(), 8U);
  EXPECT_EQ(called.front(), (Cell{0, 0}));
  EXPECT_EQ(called.back(), (Cell{3, 1}));
  for (const Cell cell : called) EXPECT_EQ(made->terrain(cell), 1 + cell.x + 10.0 * cell.y);
  EXPECT_EQ(made->occupied(), map.occupied());
  EXPECT_EQ(made->unknown(), map.unknown());
  EXPECT_EQ(made->frame(), map.frame());
  EXPECT_EQ(map.terrain({0, 0}), 3) << "the map itself does not change";
}

TEST(OwnCosts, ComeFromABufferAndGoWithAnEmptyOne) {
  const auto made = with_terrain(corridor(), Grid<double>(4, 2, {1, 2, 3, 4, 5, 6, 7, 8}));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->terrain({1, 1}), 6);
  const auto plain = with_terrain(*made, Grid<double>());
  ASSERT_TRUE(plain);
  EXPECT_TRUE(plain->uniform_terrain());
}

TEST(OwnCosts, AreRefusedBelowOneNotFiniteOrOfAnotherSize) {
  const auto below = with_terrain(corridor(), [](Cell cell) { return cell.x == 3 ? 0.5 : 1; });
  ASSERT_FALSE(below);
  EXPECT_EQ(below.error().status, Status::invalid_map);
  EXPECT_EQ(below.error().message,
            "the terrain of cell (3,0) is 0.5: a multiplier is at least 1 and finite");
  EXPECT_FALSE(with_terrain(corridor(), [](Cell) { return std::nan(""); }));
  EXPECT_FALSE(with_terrain(corridor(), Grid<double>(2, 4, 1)));
}

}  // namespace
}  // namespace wend
