#include <gtest/gtest.h>

#include <string>

#include "wend/generate/generated_map_test.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {
namespace {

using test::drawn;
using test::error_of;
using test::made;

GridMap car_park(int width, int height, std::uint64_t seed, const OptionValues& options) {
  return made("car_park", width, height, seed, options);
}

std::size_t objects(const GridMap& map) {
  return ConnectedComponents(map.occupied()).count(Adjacency::edges_and_corners);
}

TEST(CarParkGenerator, LooksTheSameOnEveryPlatform) {
  EXPECT_EQ(drawn(car_park(58, 44, 8, {{"bay_width", "0.6"}, {"occupied", "1"}})),
            "??????????????????????????????????????????????????????????\n"
            "??????????????????????????????????????????????????????????\n"
            "??????????????????????????????????????????????????????????\n"
            "???####################################################???\n"
            "???####################################################???\n"
            "???####################################################???\n"
            "???###..............#................#..............###???\n"
            "???###..............#...##########...#..............###???\n"
            "???###..............#...##########...#..............###???\n"
            "???###..............#...##########...#..............###???\n"
            "???###..............#...##########...#..............###???\n"
            "???###..............#................#..............###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............................................###???\n"
            "???###..............#................#..............###???\n"
            "???###..............#..#####...####..#..............###???\n"
            "???###..............#..#####...####..#..............###???\n"
            "???###..............#..#####...####..#..............###???\n"
            "???###..............#..####....####..#..............###???\n"
            "???###..............#..####....####..#..............###???\n"
            "???###..............#..####....####..#..............###???\n"
            "???###..............#..####....####..#..............###???\n"
            "???###..............#..####....####..#..............###???\n"
            "???###..............#..####....####..#..............###???\n"
            "???###..............#..####....####..#..............###???\n"
            "???###..............#................#..............###???\n"
            "???####################################################???\n"
            "???####################################################???\n"
            "???####################################################???\n"
            "??????????????????????????????????????????????????????????\n"
            "??????????????????????????????????????????????????????????\n"
            "??????????????????????????????????????????????????????????\n");
}

TEST(CarParkGenerator, ParksCarsInTheShareOfBaysThatItIsTold) {
  const auto occupied = [](double share) {
    const GridMap map = car_park(1500, 1400, 3, {{"occupied", format_number(share)}});
    return static_cast<double>(map.occupied().count());
  };
  const double kerbs = occupied(0);
  const double cars = occupied(1) - kerbs;
  EXPECT_GT(cars, 100000);
  for (const double share : {0.1, 0.5, 0.9}) {
    EXPECT_NEAR((occupied(share) - kerbs) / cars, share, 0.05);
  }
}

TEST(CarParkGenerator, HasOneObjectForEachCarAndOneOfWallsAndKerbs) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    EXPECT_EQ(objects(car_park(480, 330, seed, {{"occupied", "0"}})), 1U + 1U);
    EXPECT_EQ(objects(car_park(480, 330, seed, {{"occupied", "1"}})), 1U + 1U + 5U + 3 * 13U);
  }
}

TEST(CarParkGenerator, HasAislesAndRoadsThatACarTurnsIn) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const FreeSpace space = *make_free_space(car_park(480, 330, seed, {{"occupied", "1"}}),
                                             {.footprint = Footprint::disc(2.5)});
    EXPECT_TRUE(space.components().connected({40, 60}, {440, 200}, Adjacency::edges));
  }
}

TEST(CarParkGenerator, LetsACarIntoEmptyBaysOnly) {
  const auto reached = [](const std::string& occupied) {
    const FreeSpace space =
        *make_free_space(car_park(480, 330, 1, {{"occupied", occupied}, {"parallel", "false"}}),
                         {.footprint = Footprint::disc(1)});
    int bays = 0;
    const Cell road{40, 60};
    for (const Cell cell : every_cell(space)) {
      if (cell.y == 6 + 15 && space.components().connected(road, cell, Adjacency::edges)) ++bays;
    }
    return bays;
  };
  EXPECT_GT(reached("0.5"), reached("1") + 10);
}

TEST(CarParkGenerator, HasBaysAlongTheLowerAisleIfItIsTold) {
  const OptionValues across{{"occupied", "0"}, {"parallel", "false"}};
  const GridMap along = car_park(400, 300, 1, {{"occupied", "0"}});
  // The kerbs of the lower row are as deep as its bays.
  const auto kerb_height = [](const GridMap& map) {
    int height = 0;
    for (int y = 6; map.state({66, y}) == CellState::occupied; ++y) ++height;
    return height;
  };
  EXPECT_EQ(kerb_height(along), 25);
  EXPECT_EQ(kerb_height(car_park(400, 300, 1, across)), 50);
}

TEST(CarParkGenerator, WantsRoomForOneAisle) {
  EXPECT_EQ(error_of("car_park", 400, 100, {{"bay_width", "5"}}),
            "a map of kind 'car_park' with 400 x 100 cells is too small: it needs at least 392 x "
            "282");
}

}  // namespace
}  // namespace wend
