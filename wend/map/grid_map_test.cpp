#include "wend/map/grid_map.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace wend
