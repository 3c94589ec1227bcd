#include "wend_ros/costmap.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace wend_ros {
namespace {

TEST(Costmap, CostsAreRoughGroundAndWhereTheCentreMayNotBeIsBlocked) {
  const std::vector<std::uint8_t> costs{0, 63, 252, 253, 254, 255};
  const wend::GridMap map = *map_from_costs(costs, 3, 2, 0.05, {-1, 2});
  EXPECT_EQ(map.terrain({0, 0}), 1);
  EXPECT_EQ(map.terrain({1, 0}), 2);
  EXPECT_EQ(map.terrain({2, 0}), 5);
  EXPECT_EQ(map.state({2, 0}), wend::CellState::free);
  EXPECT_EQ(map.state({0, 1}), wend::CellState::occupied);
  EXPECT_EQ(map.state({1, 1}), wend::CellState::occupied);
  EXPECT_EQ(map.state({2, 1}), wend::CellState::unknown);
  EXPECT_EQ(map.frame().to_metres(wend::Point{0, 0}), (wend::MapPoint{-1, 2}));
}

TEST(Costmap, CostsCountAsMuchAsTheFactorSays) {
  const std::vector<std::uint8_t> costs{0, 126, 252};
  const auto map = map_from_costs(costs, 3, 1, 0.05, {0, 0}, 0.8);
  ASSERT_TRUE(map);
  EXPECT_DOUBLE_EQ(map->terrain({1, 0}), 1.4);
  EXPECT_DOUBLE_EQ(map->terrain({2, 0}), 1.8);
  EXPECT_FALSE(map_from_costs(costs, 3, 2, 0.05, {0, 0})) << "6 costs expected";
}

}  // namespace
}  // namespace wend_ros
