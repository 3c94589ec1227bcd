#include "wend/generate/generators.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/generate/generated_map_test.hpp"
#include "wend/map/random_bits_test.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {
namespace {

using test::drawn;
using test::error_of;
using test::made;

std::size_t free_cells(const GridMap& map) {
  return map.size() - map.occupied().count() - map.unknown().count();
}

class EachGenerator : public testing::TestWithParam<std::string> {
 protected:
  const GeneratorInfo& info() const { return *generators().find(GetParam()); }

  /// Runs `check(map)` on maps of many sizes, from the least one on, with default options.
  template <class Check>
  void for_maps_of_many_sizes(Check&& check) const {
    for (std::uint64_t seed = 0; seed < test::share_of(120U); ++seed) {
      Random random(seed);
      const bool least = seed % 8 == 0;
      const int width = info().least_width + (least ? 0 : random.between(0, 180));
      const int height = info().least_height + (least ? 0 : random.between(0, 180));
      SCOPED_TRACE(testing::Message() << width << " x " << height << ", seed " << seed);
      const auto map = info().make(width, height, seed, {});
      ASSERT_TRUE(map.has_value()) << map.error().message;
      ASSERT_EQ(map->width(), width);
      ASSERT_EQ(map->height(), height);
      check(*map);
      if (HasFatalFailure()) return;
    }
  }

  Cell start() const { return {info().free_corner, info().free_corner}; }
  Cell goal(const GridMap& map) const {
    return {map.width() - 1 - info().free_corner, map.height() - 1 - info().free_corner};
  }
};

TEST_P(EachGenerator, SaysWhatItIs) {
  EXPECT_EQ(info().name, GetParam());
  EXPECT_FALSE(info().summary.empty());
  EXPECT_FALSE(info().options.empty());
}

TEST_P(EachGenerator, HasADefaultSizeThatItTakes) {
  const auto map = info().make(info().default_width, info().default_height, 1, {});
  EXPECT_TRUE(map.has_value()) << map.error().message;
}

TEST_P(EachGenerator, MakesTheSameMapFromTheSameSeed) {
  const auto text = [&](std::uint64_t seed) { return drawn(made(GetParam(), 220, 170, seed)); };
  EXPECT_EQ(text(7), text(7));
  EXPECT_NE(text(7), text(8));
}

TEST_P(EachGenerator, ConnectsAllFreeCellsWhereItSaysSo) {
  if (!info().connected) return;
  for_maps_of_many_sizes([](const GridMap& map) {
    ASSERT_EQ(make_free_space(map)->components().count(Adjacency::edges), 1U) << drawn(map);
  });
}

TEST_P(EachGenerator, KeepsTheCornersForStartAndGoalFree) {
  for_maps_of_many_sizes([&](const GridMap& map) {
    for (const Cell corner : {start(), goal(map)}) {
      ASSERT_TRUE(!map.contains(corner) || map.state(corner) == CellState::free) << drawn(map);
    }
  });
}

TEST_P(EachGenerator, RefusesSizesThatAreTooSmall) {
  const auto error = info().make(info().least_width - 1, info().least_height - 1, 1, {});
  ASSERT_FALSE(error.has_value());
  EXPECT_NE(error.error().message.find("too small: it needs at least"), std::string::npos);
  if (info().name != "car") {  // it needs a number of cells, in any shape
    EXPECT_FALSE(info().make(info().least_width - 1, info().least_height, 1, {}).has_value());
    EXPECT_FALSE(info().make(info().least_width, info().least_height - 1, 1, {}).has_value());
  }
  EXPECT_FALSE(info().make(0, 0, 1, {}).has_value());
  EXPECT_FALSE(info().make(-5, 1000, 1, {}).has_value());
  EXPECT_FALSE(info().make(INT32_MIN, INT32_MIN, 1, {}).has_value());
}

TEST_P(EachGenerator, RefusesSizesThatAreTooLarge) {
  const auto error = info().make(kMostGeneratedCells + 1, 200, 1, {});
  ASSERT_FALSE(error.has_value());
  EXPECT_NE(error.error().message.find("too large: it can have at most"), std::string::npos);
  EXPECT_FALSE(info().make(INT32_MAX, INT32_MAX, 1, {}).has_value());
}

TEST_P(EachGenerator, RefusesWrongOptions) {
  const int side = 400;
  for (const OptionInfo& option : info().options) {
    EXPECT_FALSE(info().make(side, side, 1, {{option.name, "nonsense"}}).has_value());
  }
  const auto error = info().make(side, side, 1, {{"colour", "red"}});
  ASSERT_FALSE(error.has_value());
  EXPECT_EQ(error.error().message.find("unknown option 'colour': "), 0U);
}

TEST_P(EachGenerator, TakesBothEndsOfEveryRange) {
  const int side = test::share_of(1100);
  for (const OptionInfo& option : info().options) {
    for (const double value : {option.least, option.greatest}) {
      if (option.kind == OptionKind::flag || option.kind == OptionKind::choice) continue;
      SCOPED_TRACE(testing::Message() << option.name << " = " << value);
      const auto map = info().make(side, side, 3, {{option.name, format_number(value)}});
      if (!map) continue;  // a corridor this wide needs a larger map
      const Cell corner = start();
      EXPECT_EQ(map->state(corner), CellState::free);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EachGenerator, testing::ValuesIn(generators().names()),
                         [](const auto& instance) { return instance.param; });

TEST(Generators, AreTheseNine) {
  EXPECT_EQ(generators().names(),
            (std::vector<std::string>{"random", "maze", "rooms", "office", "warehouse", "rough",
                                      "car", "parking", "car_park"}));
}

TEST(RandomGenerator, BlocksTheShareThatItIsTold) {
  for (const double density : {0.0, 0.05, 0.2, 0.5, 0.9, 1.0}) {
    const GridMap map = made("random", 300, 200, 1, {{"density", format_number(density)}});
    const auto blocked = static_cast<double>(map.occupied().count());
    EXPECT_NEAR(blocked / static_cast<double>(map.size()), density, 0.01);
    EXPECT_EQ(map.unknown().count(), 0U);
    EXPECT_TRUE(map.uniform_terrain());
  }
}

TEST(RandomGenerator, MakesMapsOfAnyShape) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 50}, {50, 1}, {2, 2}}) {
    EXPECT_EQ(made("random", width, height, 1, {{"density", "0"}}).occupied().count(), 0U);
  }
}

TEST(MazeGenerator, LooksTheSameOnEveryPlatform) {
  EXPECT_EQ(drawn(made("maze", 15, 9, 7)),
            "###############\n"
            "#.#.........#.#\n"
            "#.#.#.#####.#.#\n"
            "#.#.#.#...#.#.#\n"
            "#.#.#.#.###.#.#\n"
            "#.#.#.#.#...#.#\n"
            "#.###.#.#.###.#\n"
            "#.....#.......#\n"
            "###############\n");
}

TEST(MazeGenerator, LeavesOneWayBetweenAnyTwoPlaces) {
  // The map is connected, and has as many openings as a tree of its chambers has edges.
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const int corridor = random.between(1, 4);
    const int columns = random.between(1, 20);
    const int rows = random.between(1, 20);
    const GridMap maze = made("maze", 1 + columns * (corridor + 1), 1 + rows * (corridor + 1), seed,
                              {{"corridor_width", std::to_string(corridor)}});
    ASSERT_EQ(make_free_space(maze)->components().count(Adjacency::edges), 1U);
    ASSERT_EQ(free_cells(maze), static_cast<std::size_t>(columns * rows * corridor * corridor +
                                                         (columns * rows - 1) * corridor));
  }
}

TEST(MazeGenerator, WantsRoomForOneCorridor) {
  EXPECT_EQ(error_of("maze", 6, 9, {{"corridor_width", "5"}}),
            "a map of kind 'maze' with 6 x 9 cells is too small: it needs at least 7 x 7");
  EXPECT_EQ(error_of("maze", 7, 7, {{"corridor_width", "5"}}), "no error");
}

TEST(RoomsGenerator, LooksTheSameOnEveryPlatform) {
  EXPECT_EQ(drawn(made("rooms", 16, 11, 7, {{"room_size", "4"}})),
            "################\n"
            "#....#....#....#\n"
            "#....#....#....#\n"
            "#....#.........#\n"
            "#....#....#....#\n"
            "##.########.####\n"
            "#.........#....#\n"
            "#....#....#....#\n"
            "#....#....#....#\n"
            "#....#.........#\n"
            "################\n");
}

TEST(RoomsGenerator, WithoutLoopsHasOneDoorFewerThanRooms) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const int size = random.between(1, 7);
    const int columns = random.between(1, 9);
    const int rows = random.between(1, 9);
    const GridMap rooms = made("rooms", 1 + columns * (size + 1), 1 + rows * (size + 1), seed,
                               {{"room_size", std::to_string(size)}, {"loops", "0"}});
    ASSERT_EQ(make_free_space(rooms)->components().count(Adjacency::edges), 1U);
    ASSERT_EQ(free_cells(rooms),
              static_cast<std::size_t>(columns * rows * size * size + columns * rows - 1));
  }
}

TEST(RoomsGenerator, WithAllLoopsHasADoorInEveryWall) {
  const GridMap rooms =
      made("rooms", 1 + 6 * 5, 1 + 4 * 5, 1, {{"room_size", "4"}, {"loops", "1"}});
  EXPECT_EQ(free_cells(rooms), 6U * 4 * 16 + (5 * 4 + 6 * 3));
}

class EachBuilding : public EachGenerator {};

TEST_P(EachBuilding, IsInMetresWithTheLowerLeftCornerAtZero) {
  const Frame frame = made(GetParam(), 220, 170, 7).frame();
  EXPECT_EQ(frame, (Frame{.resolution = 0.1, .origin = {}, .y_up = true, .metric = true}));
}

TEST_P(EachBuilding, LetsARobotOf30CentimetresGetFromStartToGoal) {
  for_maps_of_many_sizes([&](const GridMap& map) {
    const FreeSpace space = *make_free_space(map, {.footprint = Footprint::disc(0.3)});
    ASSERT_TRUE(space.components().connected(start(), goal(map), Adjacency::edges)) << drawn(map);
  });
}

TEST_P(EachBuilding, LetsARobotOf20CentimetresIntoAlmostEveryCorner) {
  for_maps_of_many_sizes([&](const GridMap& map) {
    const FreeSpace space = *make_free_space(map, {.footprint = Footprint::disc(0.2)});
    const auto largest = static_cast<double>(space.components().sizes(Adjacency::edges).front());
    ASSERT_GT(largest, 0.9 * static_cast<double>(space.passable().count())) << drawn(map);
  });
}

TEST_P(EachBuilding, HasNoHoleInItsOuterWall) {
  for_maps_of_many_sizes([](const GridMap& map) {
    const FreeSpace space = *make_free_space(map, {.unknown = UnknownPolicy::free});
    ASSERT_EQ(map.state({0, 0}), CellState::unknown);
    for (const Cell cell : test::all_cells(map.width(), map.height())) {
      if (map.state(cell) != CellState::free) continue;
      ASSERT_FALSE(space.components().connected({0, 0}, cell, Adjacency::edges_and_corners))
          << cell.x << "," << cell.y << '\n'
          << drawn(map);
    }
  });
}

TEST_P(EachBuilding, IsMadeOfFloorForALargePart) {
  for_maps_of_many_sizes(
      [](const GridMap& map) { ASSERT_GT(free_cells(map), map.size() / 4) << drawn(map); });
}

INSTANTIATE_TEST_SUITE_P(Buildings, EachBuilding,
                         testing::Values("office", "warehouse", "car_park"),
                         [](const auto& instance) { return instance.param; });

TEST(OfficeGenerator, CanBeUnfurnished) {
  const GridMap empty = made("office", 160, 100, 7, {{"furniture", "false"}});
  EXPECT_GT(free_cells(empty), free_cells(made("office", 160, 100, 7)));
  EXPECT_EQ(make_free_space(empty)->components().count(Adjacency::edges), 1U);
}

TEST(OfficeGenerator, LetsTheDemosRobotGetFromOneEndToTheOther) {
  const FreeSpace space =
      *make_free_space(made("office", 160, 100, 7), {.footprint = Footprint::disc(0.2)});
  const Frame& frame = space.map().frame();
  EXPECT_TRUE(space.components().connected(frame.cell_at({1, 1}).value(),
                                           frame.cell_at({15, 9}).value(), Adjacency::edges));
}

TEST(WarehouseGenerator, WantsRoomForOneAisle) {
  EXPECT_EQ(error_of("warehouse", 400, 100, {{"aisle_width", "10"}}),
            "a map of kind 'warehouse' with 400 x 100 cells is too small: it needs at least 134 x "
            "239");
}

TEST(RoughGenerator, LooksTheSameOnEveryPlatform) {
  EXPECT_EQ(drawn(made("rough", 30, 10, 7, {{"hill_size", "6"}, {"rocks", "0.1"}})),
            "553.....242333448998768##86652\n"
            "554.......24455699987887677753\n"
            "434#..#....#36789999998556##64\n"
            "....###.##.#.356788###6456#776\n"
            "..............2356545655677899\n"
            "................453222##888899\n"
            "................2322#####87899\n"
            "......2.........243...47766676\n"
            "......2.......23344...2456#54.\n"
            "....233........3332.....#322..\n");
}

TEST(RoughGenerator, HasTheSharesThatItIsTold) {
  for (const double share : {0.0, 0.1, 0.5, 1.0}) {
    SCOPED_TRACE(share);
    const std::string text = format_number(share);
    const GridMap rough = made("rough", 200, 150, 5, {{"roughness", text}, {"rocks", "0"}});
    const auto cells = static_cast<double>(rough.size());
    const auto terrain = rough.terrain().values();
    const auto hard = std::count_if(terrain.begin(), terrain.end(), [](double c) { return c > 1; });
    EXPECT_NEAR(static_cast<double>(hard) / cells, share, 0.01);
    EXPECT_EQ(rough.occupied().count(), 0U);

    const GridMap rocky = made("rough", 200, 150, 5, {{"rocks", text}});
    EXPECT_NEAR(static_cast<double>(rocky.occupied().count()) / cells, share, 0.01);
  }
}

TEST(RoughGenerator, CostsWholeNumbersFrom1To9WithSmoothSlopes) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const GridMap rough = made("rough", 120, 90, seed);
    double greatest = 0;
    double steps = 0;
    for (const Cell cell : test::all_cells(120, 90)) {
      const double cost = rough.terrain(cell);
      ASSERT_EQ(cost, std::floor(cost));
      ASSERT_GE(cost, 1);
      ASSERT_LE(cost, 9);
      greatest = std::max(greatest, cost);
      if (cell.x > 0) steps += std::abs(cost - rough.terrain({cell.x - 1, cell.y}));
    }
    EXPECT_EQ(greatest, 9);
    EXPECT_LT(steps / (120 * 90), 0.6);  // random costs would differ by 2.7
  }
}

}  // namespace
}  // namespace wend
