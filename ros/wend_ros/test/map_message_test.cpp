#include "wend_ros/map_message.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "wend/generate/generators.hpp"

namespace wend_ros {
namespace {

nav_msgs::OccupancyGrid message(std::uint32_t width, std::uint32_t height, float resolution) {
  nav_msgs::OccupancyGrid grid;
  grid.info.width = width;
  grid.info.height = height;
  grid.info.resolution = resolution;
  grid.info.origin.orientation.w = 1;
  grid.data.assign(std::size_t{width} * height, 0);
  return grid;
}

TEST(MapMessage, TurnsAMapWithYDownOver) {
  wend::Grid<wend::CellState> cells(2, 3, wend::CellState::free);
  cells[{1, 0}] = wend::CellState::occupied;  // drawn at the top
  cells[{0, 2}] = wend::CellState::unknown;
  const auto grid = to_message(*wend::make_grid_map(cells), "map");
  const std::vector<std::int8_t> expected{-1, 0, 0, 0, 0, 100};
  EXPECT_EQ(grid.data, expected) << "the row at the bottom comes first";
}

TEST(MapMessage, ComesBackAsTheSameMap) {
  for (const char* kind : {"office", "warehouse"}) {
    const auto map = wend::make_map(kind, 220, 160, 3);
    ASSERT_TRUE(map);
    const auto back = map_from(to_message(*map, "map"), {});
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->frame(), map->frame()) << "resolution too: 0.1 is no float";
    for (int y = 0; y < map->height(); ++y) {
      for (int x = 0; x < map->width(); ++x) ASSERT_EQ(back->state({x, y}), map->state({x, y}));
    }
  }
}

TEST(MapMessage, KeepsRoughGround) {
  wend::Grid<wend::CellState> cells(3, 1, wend::CellState::free);
  wend::Grid<double> terrain(3, 1, 1);
  terrain[{1, 0}] = 2;
  terrain[{2, 0}] = 1000;
  const auto grid = to_message(*wend::make_grid_map(cells, {}, terrain), "map");
  EXPECT_EQ(grid.data, (std::vector<std::int8_t>{0, 25, 99})) << "rough is never an obstacle";
  const auto back = map_from(grid, {.occupied_from = 100, .rough = true});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->terrain({1, 0}), 2);
  const auto dearer = map_from(grid, {.occupied_from = 100, .rough = true, .cost_factor = 8});
  EXPECT_EQ(dearer->terrain({1, 0}), 3);
  const auto plain = map_from(grid, {});
  EXPECT_TRUE(plain->uniform_terrain());
  EXPECT_EQ(plain->state({2, 0}), wend::CellState::occupied) << "99 is above the threshold";
}

TEST(MapMessage, ThatIsNoMapSaysWhy) {
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(map_from(message(0, 0, 1), {}).error().message, "the map is empty: 0 x 0 cells");
  for (const float resolution : {0.0F, -1.0F, not_a_number, 1e12F, 1e38F, 1e-30F}) {
    const auto map = map_from(message(4, 4, resolution), {});
    ASSERT_FALSE(map);
    EXPECT_EQ(map.error().status, wend::Status::invalid_map);
    EXPECT_NE(map.error().message.find("resolution"), std::string::npos) << map.error().message;
  }
  auto cut = message(4, 4, 1);
  cut.data.pop_back();
  EXPECT_EQ(map_from(cut, {}).error().message, "the map has 15 values, 4 x 4 expected");
  auto astray = message(4, 4, 1);
  astray.info.origin.position.x = not_a_number;
  EXPECT_FALSE(map_from(astray, {}));
  auto unset = message(4, 4, 1);
  unset.info.origin.orientation = {};
  EXPECT_EQ(map_from(unset, {}).error().message,
            "the map's origin has the orientation (0, 0, 0, 0), whose length is 0, not 1");
  auto tilted = message(4, 4, 1);
  tilted.info.origin.orientation.w = 0;
  tilted.info.origin.orientation.x = 1;
  EXPECT_EQ(map_from(tilted, {}).error().message,
            "the map's origin has the orientation (1, 0, 0, 0), which is tilted by 180 degrees");
  auto absurd = message(4, 4, 1);
  absurd.info.width = absurd.info.height = 4'000'000'000U;
  EXPECT_FALSE(map_from(absurd, {}));
}

}  // namespace
}  // namespace wend_ros
