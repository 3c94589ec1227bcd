#include "wend/map/occupancy.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace wend {
namespace {

constexpr Frame kOccupancyFrame{
    .resolution = 0.05, .origin = {1, 2, 0}, .y_up = true, .metric = true};

/// Every value of a byte, in one row.
template <class Byte>
std::vector<Byte> all_bytes() {
  std::vector<Byte> bytes(256);
  std::iota(bytes.begin(), bytes.end(), std::numeric_limits<Byte>::min());
  return bytes;
}

TEST(Occupancy, OfEveryValueIsWhatRosSays) {
  const auto values = all_bytes<std::int8_t>();
  for (const int occupied_from : {1, 50, 65, 100}) {
    for (const double factor : {0.0, 1.0, 4.0, 99.5}) {
      const auto map = map_from_occupancy(values, 256, 1, kOccupancyFrame,
                                          {.occupied_from = occupied_from, .cost_factor = factor});
      ASSERT_TRUE(map) << map.error().message;
      EXPECT_EQ(map->frame(), kOccupancyFrame);
      for (int x = 0; x < 256; ++x) {
        const int v = values[static_cast<std::size_t>(x)];
        SCOPED_TRACE(testing::Message() << "value " << v);
        if (v < 0 || v > 100) {
          EXPECT_EQ(map->state({x, 0}), CellState::unknown);
        } else if (v >= occupied_from) {
          EXPECT_EQ(map->state({x, 0}), CellState::occupied);
        } else {
          EXPECT_EQ(map->state({x, 0}), CellState::free);
          EXPECT_DOUBLE_EQ(map->terrain({x, 0}), 1 + factor * v / 100);
        }
      }
    }
  }
}

TEST(Occupancy, OfEveryCostOfACostmapIsWhatCostmap2dSays) {
  const auto costs = all_bytes<std::uint8_t>();
  for (const double factor : {0.0, 0.8, 4.0, 1e6}) {
    const auto map = map_from_costmap(costs, 256, 1, kOccupancyFrame, {factor});
    ASSERT_TRUE(map) << map.error().message;
    for (int v = 0; v <= 252; ++v) {
      EXPECT_EQ(map->state({v, 0}), CellState::free) << v;
      EXPECT_DOUBLE_EQ(map->terrain({v, 0}), 1 + factor * v / 252) << v;
    }
    EXPECT_EQ(map->state({253, 0}), CellState::occupied) << "inscribed";
    EXPECT_EQ(map->state({254, 0}), CellState::occupied) << "lethal";
    EXPECT_EQ(map->state({255, 0}), CellState::unknown);
  }
}

TEST(Occupancy, OfACostmapForTheRealRobotOnlyLethalCellsAreBlocked) {
  const auto costs = all_bytes<std::uint8_t>();
  const CostmapScale scale{.cost_factor = 2, .inscribed_blocked = false};
  const auto map = map_from_costmap(costs, 256, 1, kOccupancyFrame, scale);
  ASSERT_TRUE(map) << map.error().message;
  for (int x = 0; x < 256; ++x) {
    const auto cost = static_cast<std::uint8_t>(x);
    const CellMeaning meaning = meaning_of_cost(cost, scale);
    EXPECT_EQ(map->state({x, 0}), meaning.state) << x;
    EXPECT_EQ(map->terrain({x, 0}), meaning.terrain) << x;
    EXPECT_EQ(meaning.state == CellState::occupied, x == 254) << x;
  }
  EXPECT_EQ(map->terrain({253, 0}), map->terrain({252, 0}));
  EXPECT_EQ(map->terrain({252, 0}), 3);
}

TEST(Occupancy, OfASpeedMaskIsTheTimeThatACellTakes) {
  const auto values = all_bytes<std::int8_t>();
  const auto check = [&](const SpeedScale& scale) {
    const auto map = map_from_speed_mask(values, 256, 1, kOccupancyFrame, scale);
    ASSERT_TRUE(map) << map.error().message;
    const double top = scale.top_speed.value_or(100);
    for (int x = 0; x < 256; ++x) {
      const int v = values[static_cast<std::size_t>(x)];
      SCOPED_TRACE(testing::Message() << "value " << v);
      ASSERT_EQ(map->state({x, 0}), v < 0 || v > 100 ? CellState::unknown : CellState::free);
      const double limit = scale.base + scale.multiplier * v;
      const bool slower = v > 0 && v <= 100 && limit > 0 && limit < top;
      EXPECT_DOUBLE_EQ(map->terrain({x, 0}), slower ? top / limit : 1);
    }
  };
  check({});
  check({.base = 100, .multiplier = -1});
  check({.base = 0, .multiplier = 0.02, .top_speed = 1.2});
  check({.base = -50, .multiplier = 3});
}

TEST(Occupancy, LiesRowByRowFromCellZero) {
  const std::vector<std::int8_t> values{0, 10, 100, -1, 0, 20};
  const auto map = map_from_occupancy(values, 3, 2, kOccupancyFrame, {.cost_factor = 100});
  ASSERT_TRUE(map);
  EXPECT_EQ(map->terrain({1, 0}), 11);
  EXPECT_EQ(map->state({2, 0}), CellState::occupied);
  EXPECT_EQ(map->state({0, 1}), CellState::unknown);
  EXPECT_EQ(map->terrain({2, 1}), 21);
}

TEST(Occupancy, WithoutCostsIsUniform) {
  const std::vector<std::int8_t> values{0, 10, 100, 64};
  EXPECT_TRUE(map_from_occupancy(values, 2, 2, kOccupancyFrame)->uniform_terrain());
  const std::vector<std::uint8_t> costs{0, 10, 254, 252};
  EXPECT_TRUE(
      map_from_costmap(costs, 2, 2, kOccupancyFrame, {.cost_factor = 0})->uniform_terrain());
}

TEST(Occupancy, IsRefusedWithTheReason) {
  const std::vector<std::int8_t> values(6, 0);
  const auto message = [](const Expected<GridMap, Error>& made) {
    return made ? std::string()
                : std::string(to_string(made.error().status)) + ": " + made.error().message;
  };
  EXPECT_EQ(message(map_from_occupancy(values, 3, 3, kOccupancyFrame)),
            "invalid_map: the map has 6 values, 3 x 3 expected");
  EXPECT_EQ(message(map_from_occupancy({}, 0, 3, kOccupancyFrame)),
            "invalid_map: the map is empty: 0 x 3 cells");
  EXPECT_EQ(message(map_from_occupancy(values, 3, 2, {.resolution = 0})),
            "invalid_map: the resolution 0 is not a positive number of metres a cell");
  EXPECT_EQ(message(map_from_occupancy(values, 1 << 30, 1 << 30, kOccupancyFrame)),
            "invalid_map: the map has 1073741824 x 1073741824 cells, more than 1073741824");
  EXPECT_EQ(message(map_from_occupancy(values, 3, 2, kOccupancyFrame, {.occupied_from = 0})),
            "invalid_option: occupied_from is 0: a value of 1 to 100 expected");
  EXPECT_EQ(message(map_from_occupancy(values, 3, 2, kOccupancyFrame, {.cost_factor = -1})),
            "invalid_option: the cost factor is -1: 0 to 1e6 expected");
  EXPECT_EQ(message(map_from_costmap(std::vector<std::uint8_t>(6), 3, 2, kOccupancyFrame,
                                     {std::nan("")})),
            "invalid_option: the cost factor is nan: 0 to 1e6 expected");
  EXPECT_EQ(message(map_from_speed_mask(values, 3, 2, kOccupancyFrame, {.top_speed = 0})),
            "invalid_option: the speed mask's top_speed is 0: a finite number of m/s above 0 "
            "expected");
  EXPECT_EQ(message(map_from_speed_mask(values, 3, 2, kOccupancyFrame, {.base = INFINITY})),
            "invalid_option: the speed mask's base is inf: a finite number expected");
}

}  // namespace
}  // namespace wend
