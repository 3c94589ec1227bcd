#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "wend/base/random.hpp"
#include "wend/generate/generated_map_test.hpp"
#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

using test::all_cells;
using test::drawn;
using test::error_of;
using test::made;

GridMap yard(int width, int height, std::uint64_t seed, int obstacles, int rough) {
  return made("car", width, height, seed,
              {{"obstacles", std::to_string(obstacles)}, {"rough", std::to_string(rough)}});
}

std::size_t rough_cells(const GridMap& map) {
  std::size_t count = 0;
  for (const Cell cell : all_cells(map.width(), map.height())) {
    count += map.terrain(cell) == 2 ? 1 : 0;
  }
  return count;
}

TEST(CarGenerator, LooksTheSameOnEveryPlatform) {
  EXPECT_EQ(drawn(yard(14, 6, 7, 12, 12)),
            "..2...2..#....\n"
            "..2.2.#2..2#..\n"
            "..2.....##....\n"
            "..#..2#.2.#2..\n"
            "2...#...#..#..\n"
            "....2#........\n");
}

TEST(CarGenerator, HasSoManyObstaclesAndRoughCellsAsItIsTold) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const int width = random.between(2, 40);
    const int height = random.between(1, 40);
    const int room = width * height - 2;
    const int obstacles = random.between(0, room);
    const int rough = random.chance(0.2) ? room - obstacles : random.between(0, room - obstacles);
    const GridMap map = yard(width, height, seed, obstacles, rough);
    ASSERT_EQ(map.occupied().count(), static_cast<std::size_t>(obstacles));
    ASSERT_EQ(map.unknown().count(), 0U);
    ASSERT_EQ(rough_cells(map), static_cast<std::size_t>(rough));
    for (const Cell cell : all_cells(width, height)) {
      ASSERT_TRUE(map.terrain(cell) == 1 || map.state(cell) == CellState::free);
    }
    ASSERT_EQ(map.uniform_terrain(), rough == 0);
    for (const Cell corner : {Cell{0, 0}, Cell{width - 1, height - 1}}) {
      ASSERT_EQ(map.state(corner), CellState::free);
      ASSERT_EQ(map.terrain(corner), 1);
    }
  }
}

TEST(CarGenerator, HasTwentyFiveOfEachUnlessToldOtherwise) {
  const GridMap map = made("car", 20, 20, 1);
  EXPECT_EQ(map.occupied().count(), 25U);
  EXPECT_EQ(rough_cells(map), 25U);
  EXPECT_EQ(map.frame(), Frame{});
}

TEST(CarGenerator, StrewsThemEvenly) {
  constexpr int kSeeds = 4000;
  Grid<int> obstacles(5, 4);
  Grid<int> rough(5, 4);
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const GridMap map = yard(5, 4, seed, 3, 6);
    for (const Cell cell : all_cells(5, 4)) {
      obstacles[cell] += map.state(cell) == CellState::occupied ? 1 : 0;
      rough[cell] += map.terrain(cell) == 2 ? 1 : 0;
    }
  }
  for (const Cell cell : all_cells(5, 4)) {
    if (cell == Cell{0, 0} || cell == Cell{4, 3}) continue;
    SCOPED_TRACE(testing::Message() << cell.x << ',' << cell.y);
    EXPECT_NEAR(obstacles[cell], kSeeds * 3 / 18, 120) << "five standard deviations";
    EXPECT_NEAR(rough[cell], kSeeds * 6 / 18, 150);
  }
}

TEST(CarGenerator, SaysHowManyFit) {
  EXPECT_EQ(error_of("car", 5, 5),
            "a map of kind 'car' with 5 x 5 cells is too small: it needs at least 52 cells, for "
            "only 23 can be obstacles or rough, not 50");
  const auto error = [](int width, int height, int obstacles, int rough) {
    return error_of("car", width, height,
                    {{"obstacles", std::to_string(obstacles)}, {"rough", std::to_string(rough)}});
  };
  EXPECT_EQ(error(5, 5, 20, 3), "no error");
  EXPECT_NE(error(5, 5, 20, 4), "no error");
  EXPECT_NE(error(5, 5, 24, 0), "no error");
  EXPECT_EQ(error(1, 1, 0, 0), "no error");
  EXPECT_NE(error(1, 1, 1, 0), "no error");
  EXPECT_EQ(error(52, 1, 25, 25), "no error") << "a long yard";
}

}  // namespace
}  // namespace wend
