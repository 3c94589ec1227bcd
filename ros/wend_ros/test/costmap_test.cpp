#include "wend_ros/costmap.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace wend_ros {
namespace {

TEST(Costmap, CostsAreRoughGroundAndWhereTheCentreMayNotBeIsBlocked) {
  const std::vector<std::uint8_t> costs{0, 63, 252, 253, 254, 255};
  const wend::GridMap map = map_from_costs(costs, 3, 2, 0.05, {-1, 2});
  EXPECT_EQ(map.terrain({0, 0}), 1);
  EXPECT_EQ(map.terrain({1, 0}), 2);
  EXPECT_EQ(map.terrain({2, 0}), 5);
  EXPECT_EQ(map.state({2, 0}), wend::CellState::free);
  EXPECT_EQ(map.state({0, 1}), wend::CellState::occupied);
  EXPECT_EQ(map.state({1, 1}), wend::CellState::occupied);
  EXPECT_EQ(map.state({2, 1}), wend::CellState::unknown);
  EXPECT_EQ(map.frame().to_metres(wend::Point{0, 0}), (wend::MapPoint{-1, 2}));
}

}  // namespace
}  // namespace wend_ros
