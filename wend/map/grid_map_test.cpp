#include "wend/map/grid_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

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
    const GridMap map(states);
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
  const GridMap map(Grid<CellState>(2, 2));
  EXPECT_TRUE(map.uniform_terrain());
  EXPECT_TRUE(map.terrain().empty());
  EXPECT_EQ(map.terrain({1, 1}), 1);
}

TEST(GridMap, KeepsTerrain) {
  Grid<double> terrain(3, 2, 1);
  terrain[{2, 0}] = 4.5;
  const GridMap map(Grid<CellState>(3, 2), {}, terrain);
  EXPECT_FALSE(map.uniform_terrain());
  EXPECT_EQ(map.terrain(), terrain);
  EXPECT_EQ(map.terrain({2, 0}), 4.5);
  EXPECT_EQ(map.terrain({0, 0}), 1);
}

TEST(GridMap, DropsTerrainThatIsOneEverywhere) {
  const GridMap map(Grid<CellState>(3, 2), {}, Grid<double>(3, 2, 1));
  EXPECT_TRUE(map.uniform_terrain());
  EXPECT_TRUE(map.terrain().empty());
}

TEST(GridMap, ContainsItsCellsAndNoOthers) {
  const GridMap map(Grid<CellState>(3, 2));
  EXPECT_TRUE(map.contains({2, 1}));
  EXPECT_FALSE(map.contains({3, 1}));
  EXPECT_FALSE(map.contains({2, -1}));
}

TEST(GridMap, TakesAnotherFrameWithTheSameCells) {
  Random random(3);
  const Grid<CellState> states = random_states(random, 5, 4);
  const GridMap map(states, {}, Grid<double>(5, 4, 2));
  const Frame frame{.resolution = 0.05, .origin = {1, 2, 0.5}, .y_up = true, .metric = true};
  const GridMap moved = map.with_frame(frame);
  EXPECT_EQ(moved.frame(), frame);
  EXPECT_EQ(map.frame(), Frame{});
  EXPECT_EQ(moved.occupied(), map.occupied());
  EXPECT_EQ(moved.unknown(), map.unknown());
  EXPECT_EQ(moved.terrain(), map.terrain());
}

TEST(GridMap, SharesItsCellsWithCopies) {
  const GridMap map(Grid<CellState>(5, 4));
  const GridMap copy = map;  // NOLINT(performance-unnecessary-copy-initialization): it is tested
  EXPECT_EQ(&copy.occupied(), &map.occupied());
}

RC_GTEST_PROP(GridMapBuilder, BuildsWhatTheConstructorDoes, ()) {
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
  const GridMap map = std::move(rows).finish(frame);
  const GridMap expected(cells, frame, terrain);
  RC_ASSERT(map.occupied() == expected.occupied());
  RC_ASSERT(map.unknown() == expected.unknown());
  RC_ASSERT(map.terrain() == expected.terrain());
  RC_ASSERT(map.frame() == expected.frame());
}

}  // namespace
}  // namespace wend
