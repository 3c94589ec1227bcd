#include "wend/map/grid_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <limits>

#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

Grid<CellState> random_states(Random& random, int width, int height) {
  constexpr std::array kStates{CellState::free, CellState::occupied, CellState::unknown};
  Grid<CellState> states(width, height);
  for (const Cell cell : test::all_cells(width, height)) states[cell] = kStates[random.below(3)];
  return states;
}

TEST(GridMap, KeepsTheStateOfEveryCell) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Grid<CellState> states =
        random_states(random, random.between(1, 140), random.between(1, 12));
    const GridMap map = *make_grid_map(states);
    ASSERT_EQ(map.width(), states.width());
    ASSERT_EQ(map.height(), states.height());
    ASSERT_EQ(map.size(), states.size());
    for (const Cell cell : test::all_cells(map.width(), map.height())) {
      ASSERT_EQ(map.state(cell), states[cell]) << cell.x << "," << cell.y;
      ASSERT_EQ(map.occupied()[cell], states[cell] == CellState::occupied);
      ASSERT_EQ(map.unknown()[cell], states[cell] == CellState::unknown);
    }
  }
}

TEST(GridMap, WithoutTerrainCostsOneEverywhere) {
  const GridMap map = *make_grid_map(Grid<CellState>(2, 2));
  EXPECT_TRUE(map.uniform_terrain());
  EXPECT_TRUE(map.terrain().empty());
  EXPECT_EQ(map.terrain({1, 1}), 1);
}

TEST(GridMap, KeepsTerrain) {
  Grid<double> terrain(3, 2, 1);
  terrain[{2, 0}] = 4.5;
  const GridMap map = *make_grid_map(Grid<CellState>(3, 2), {}, terrain);
  EXPECT_FALSE(map.uniform_terrain());
  EXPECT_EQ(map.terrain(), terrain);
  EXPECT_EQ(map.terrain({2, 0}), 4.5);
  EXPECT_EQ(map.terrain({0, 0}), 1);
}

TEST(GridMap, DropsTerrainThatIsOneEverywhere) {
  const GridMap map = *make_grid_map(Grid<CellState>(3, 2), {}, Grid<double>(3, 2, 1));
  EXPECT_TRUE(map.uniform_terrain());
  EXPECT_TRUE(map.terrain().empty());
}

TEST(GridMap, ContainsItsCellsAndNoOthers) {
  const GridMap map = *make_grid_map(Grid<CellState>(3, 2));
  EXPECT_TRUE(map.contains({2, 1}));
  EXPECT_FALSE(map.contains({3, 1}));
  EXPECT_FALSE(map.contains({2, -1}));
}

std::string why_no_map(const Expected<GridMap, Error>& map, const std::string& where) {
  if (map) return "a map";
  EXPECT_EQ(map.error().status, Status::invalid_map);
  EXPECT_EQ(map.error().where, where);
  return map.error().message;
}

TEST(GridMap, IsNotMadeOfPartsThatDoNotFit) {
  EXPECT_EQ(why_no_map(make_grid_map(Grid<CellState>()), "cells"), "the map has no cells");
  EXPECT_EQ(why_no_map(make_grid_map(BitGrid(3, 2), BitGrid(2, 2)), "cells"),
            "the map has 3 x 2 occupied cells, but 2 x 2 unknown cells");
  BitGrid both(3, 2);
  both.set({1, 1}, true);
  EXPECT_EQ(why_no_map(make_grid_map(both, both), "cells"),
            "a cell in row 1 is both occupied and unknown");
  const Grid<CellState> cells(3, 2);
  EXPECT_EQ(why_no_map(make_grid_map(cells, {}, Grid<double>(2, 3, 1)), "terrain"),
            "the terrain has 2 x 3 multipliers for a map of 3 x 2 cells");
}

TEST(GridMap, IsNotMadeOfValuesOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Grid<CellState> cells(3, 2);
  for (const double value : {nan, infinity, 0.5, -1.0}) {
    Grid<double> terrain(3, 2, 1);
    terrain[{2, 1}] = value;
    EXPECT_THAT(why_no_map(make_grid_map(cells, {}, terrain), "terrain"),
                testing::StartsWith("the terrain of cell (2,1) is "));
  }
  for (const double resolution : {nan, infinity, 0.0, -0.05}) {
    EXPECT_THAT(why_no_map(make_grid_map(cells, {.resolution = resolution}), "frame"),
                testing::HasSubstr("is not a positive number of metres a cell"));
  }
  EXPECT_EQ(why_no_map(make_grid_map(cells, {.origin = {0, nan, 0}}), "frame"),
            "the origin contains NaN or infinity");
}

TEST(GridMapBuilder, SaysWhichRowHasAnotherLength) {
  GridMapBuilder rows(2);
  rows.append(std::array{CellState::free, CellState::free});
  rows.append(std::array{CellState::free});
  rows.append(std::array{CellState::free, CellState::free, CellState::free});
  EXPECT_EQ(why_no_map(std::move(rows).finish(), "row 1"),
            "row 1 has 1 values, the map is 2 cells wide");
  EXPECT_EQ(why_no_map(GridMapBuilder(3).finish(), "cells"), "the map has no cells");
  EXPECT_EQ(why_no_map(GridMapBuilder(-3).finish(), "cells"), "the map has no cells");
}

TEST(GridMap, SharesItsCellsWithCopies) {
  const GridMap map = *make_grid_map(Grid<CellState>(5, 4));
  const GridMap copy = map;  // NOLINT(performance-unnecessary-copy-initialization): it is tested
  EXPECT_EQ(&copy.occupied(), &map.occupied());
}

RC_GTEST_PROP(GridMapBuilder, BuildsWhatMakeGridMapDoes, ()) {
  const int width = *rc::gen::inRange(1, 140);
  const int height = *rc::gen::inRange(1, 20);
  const Frame frame{0.5, {1, 2, 3}, *rc::gen::arbitrary<bool>(), true};
  const auto states = *rc::gen::container<std::vector<CellState>>(
      static_cast<std::size_t>(width * height),
      rc::gen::element(CellState::free, CellState::occupied, CellState::unknown));
  const auto rough_from = *rc::gen::inRange(0, 2 * height);  // rows from here on have terrain
  Grid<CellState> cells(width, height);
  Grid<double> terrain(width, height, 1);
  GridMapBuilder rows(width);
  if (*rc::gen::arbitrary<bool>()) rows.reserve(height);
  for (int from_top = 0; from_top < height; ++from_top) {
    const int y = frame.y_up ? height - 1 - from_top : from_top;
    const auto row = std::span(states).subspan(static_cast<std::size_t>(from_top * width),
                                               static_cast<std::size_t>(width));
    std::vector<double> rough;
    if (from_top >= rough_from) rough.assign(row.size(), 1 + from_top % 3);
    std::copy(row.begin(), row.end(), cells.row(y).begin());
    std::copy(rough.begin(), rough.end(), terrain.row(y).begin());
    rows.append(row, rough);
    RC_ASSERT(rows.height() == from_top + 1);
  }
  const GridMap map = *std::move(rows).finish(frame);
  const GridMap expected = *make_grid_map(cells, frame, terrain);
  RC_ASSERT(map.occupied() == expected.occupied());
  RC_ASSERT(map.unknown() == expected.unknown());
  RC_ASSERT(map.terrain() == expected.terrain());
  RC_ASSERT(map.frame() == expected.frame());
}

}  // namespace
}  // namespace wend
