#include "wend/space/grid/line_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/share.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

using test::Reference;

TEST(LineCost, IsTheIntegralOfTheMultipliersAlongTheLine) {
  int dearer = 0;
  for (std::uint64_t seed = 0; seed < test::share_of(2000U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const GridMap map = test::random_map(random);
    const FreeSpaceOptions robot = test::random_robot(random, map.frame().resolution);
    const auto space = make_free_space(map, robot);
    const Reference reference(map, test::robot_in_cells(robot, map.frame()), {});
    for (int i = 0; i < 5; ++i) {
      const Cell from = test::random_cell(random, map.width(), map.height());
      const Cell to = test::random_cell(random, map.width(), map.height());
      const double cost = line_cost(*space, from, to);
      ASSERT_NEAR(cost, reference.line_cost(from, to), 1e-9 * (1 + cost));
      ASSERT_NEAR(cost, line_cost(*space, to, from), 1e-12 * (1 + cost));
      dearer += cost > 1 + std::hypot(from.x - to.x, from.y - to.y) ? 1 : 0;
    }
  }
  EXPECT_GT(dearer, 100);
}

TEST(LineCost, OfAStepIsWhatTheStepCosts) {
  Random random(5);
  Grid<double> terrain(9, 9, 1);
  for (const Cell cell : every_cell(terrain)) terrain[cell] = 1 + 4 * random.uniform();
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(9, 9, CellState::free), {}, terrain));
  for (int x = 3; x <= 5; ++x) {
    for (int y = 3; y <= 5; ++y) {
      const std::array step{Cell{4, 4}, Cell{x, y}};
      if (step[0] == step[1]) continue;
      EXPECT_NEAR(line_cost(space, step[0], step[1]), grid_path_cost(space, step), 1e-12);
    }
  }
}

TEST(LineCost, ThroughCornersDoesNotEnterTheCellsBesideThem) {
  Grid<double> terrain(4, 4, 100);
  for (int i = 0; i < 4; ++i) terrain[{i, i}] = 2;
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(4, 4, CellState::free), {}, terrain));
  EXPECT_DOUBLE_EQ(line_cost(space, {0, 0}, {3, 3}), 2 * std::sqrt(18));
  EXPECT_DOUBLE_EQ(line_cost(space, {0, 0}, {0, 0}), 0);
  const std::vector<Cell> path{{0, 0}, {3, 3}, {3, 2}};
  EXPECT_DOUBLE_EQ(any_angle_path_cost(space, path), 2 * std::sqrt(18) + 51);
}

}  // namespace
}  // namespace wend
