#include "wend/map/value_edit.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "wend/map/occupancy.hpp"

namespace wend {
namespace {

using Costs = std::vector<std::uint8_t>;

constexpr Frame kCostmapFrame{.resolution = 0.05, .y_up = true, .metric = true};

Costs random_costs(std::mt19937& random, std::size_t count) {
  Costs costs(count);
  for (auto& cost : costs) cost = static_cast<std::uint8_t>(random() % 3 == 0 ? random() : 0);
  return costs;
}

void expect_same(const GridMap& map, const GridMap& expected) {
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      ASSERT_EQ(map.state({x, y}), expected.state({x, y})) << x << ", " << y;
      // The terrain of a cell that is not free counts for nothing.
      if (map.state({x, y}) != CellState::free) continue;
      ASSERT_EQ(map.terrain({x, y}), expected.terrain({x, y})) << x << ", " << y;
    }
  }
}

TEST(ValueEdit, MakesTheMapThatTheNewCostsMake) {
  std::mt19937 random(5);
  int sparse = 0;
  int dense = 0;
  for (int n = 0; n < 500; ++n) {
    const int width = 1 + static_cast<int>(random() % 20);
    const int height = 1 + static_cast<int>(random() % 20);
    const auto columns = static_cast<std::size_t>(width);
    const Costs before = random_costs(random, columns * static_cast<std::size_t>(height));
    Costs after = n % 3 == 0 ? random_costs(random, before.size()) : before;
    for (auto i = random() % 4; i > 0; --i) {
      after[random() % after.size()] = static_cast<std::uint8_t>(random());
    }
    const CostmapScale scale{.cost_factor = 3, .inscribed_blocked = n % 2 == 0};
    const auto read = [&](std::uint8_t cost) { return meaning_of_cost(cost, scale); };
    const MapEdit edit =
        edit_between<std::uint8_t>({before, columns}, {after, columns}, {0, 0}, read);
    GridMap map = *map_from_costmap(before, width, height, kCostmapFrame, scale);
    ASSERT_TRUE(map.edit(edit));
    expect_same(map, *map_from_costmap(after, width, height, kCostmapFrame, scale));
    sparse += edit.cells.empty() ? 0 : 1;
    dense += edit.states.empty() ? 0 : 1;
  }
  EXPECT_GT(sparse, 20);
  EXPECT_GT(dense, 20);
}

TEST(ValueEdit, OfAPartNamesCellsOfTheMap) {
  const Costs before{0, 0, 0, 0};
  const Costs after{0, 0, 0, 254};
  const auto read = [](std::uint8_t cost) { return meaning_of_cost(cost); };
  const MapEdit edit = edit_between<std::uint8_t>({before, 2}, {after, 2}, {10, 20}, read);
  EXPECT_EQ(edit.corner, (Cell{11, 21}));
  EXPECT_EQ(edit.box(), (CellBox{{11, 21}, {12, 22}}));
  EXPECT_EQ((edit.states[{0, 0}]), CellState::occupied);
}

TEST(ValueEdit, LeavesTheTerrainAsItIsIfTheValuesSayNothingOfIt) {
  const std::vector<std::int8_t> before(6, 0);
  const std::vector<std::int8_t> after(6, 100);
  const auto read = [](std::int8_t value) {
    return CellMeaning{value == 0 ? CellState::free : CellState::occupied, std::nullopt};
  };
  const MapEdit edit = edit_between<std::int8_t>({before, 3}, {after, 3}, {0, 0}, read);
  EXPECT_EQ(edit.box().size(), 6);
  EXPECT_TRUE(edit.terrain.empty());
  EXPECT_TRUE(edit_between<std::int8_t>({after, 3}, {after, 3}, {0, 0}, read).box().empty());
}

}  // namespace
}  // namespace wend
