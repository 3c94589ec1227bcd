#include "wend/space/swept_diagonal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/testing/random_map.hpp"
#include "tests/testing/textbook.hpp"

namespace wend {
namespace {

constexpr double kExact = 1e-7;  // distances are the roots of whole numbers over 8

/// The distance from the way of a step to the nearest obstacle, over all obstacles there are.
double distance_to_obstacles(const FreeSpace& space, Cell from, Cell to) {
  double least = test::kInfinite;
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      if (!space.obstacles()[{x, y}]) continue;
      least = std::min(least, test::distance_to_square(from, to, {x, y}));
    }
  }
  return least;
}

/// Calls visit(space, from, direction, to) for all diagonal steps between passable cells of random
/// maps for random discs.
template <class Visit>
void for_diagonals_of_discs(Visit&& visit) {
  for (std::uint64_t seed = 1; seed <= 300 && !::testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(2, 14), random.between(2, 14));
    FreeSpaceOptions robot = test::random_robot(random, map.frame().resolution);
    if (robot.robot_radius == 0)
      robot.robot_radius = (0.05 + 3 * random.uniform()) * map.frame().resolution;
    const FreeSpace space(map, robot);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", radius in cells " +
                 std::to_string(space.radius_in_cells()) + "\n" + test::drawing_of(map));
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        for (const Direction direction : {Direction::down_right, Direction::up_right,
                                          Direction::up_left, Direction::down_left}) {
          const Cell to = step({x, y}, direction, map.frame().y_up);
          if (space.passable({x, y}) && space.passable(to)) visit(space, Cell{x, y}, direction, to);
        }
      }
    }
  }
}

TEST(SweptDiagonal, IsFreeWhereNoObstacleComesNearerThanTheRadius) {
  int free = 0;
  int blocked = 0;
  for_diagonals_of_discs([&](const FreeSpace& space, Cell from, Direction direction, Cell to) {
    const bool expected =
        distance_to_obstacles(space, from, to) >= space.radius_in_cells() - kExact;
    (expected ? free : blocked) += 1;
    ASSERT_EQ(SweptDiagonal(space, true).free(from, direction), expected)
        << "(" << from.x << "," << from.y << ") to (" << to.x << "," << to.y << ")";
  });
  EXPECT_GT(free, 1000);
  EXPECT_GT(blocked, 100);
}

/// Why corner rule `none` needs no sweep.
TEST(SweptDiagonal, IsAlwaysFreeWhereBothCellsBesideItArePassable) {
  for_diagonals_of_discs([](const FreeSpace& space, Cell from, Direction, Cell to) {
    if (!space.passable({from.x, to.y}) || !space.passable({to.x, from.y})) return;
    ASSERT_GE(distance_to_obstacles(space, from, to), space.radius_in_cells() - kExact);
  });
}

TEST(SweptDiagonal, IsNotNeededForAPointNorWhereNoCornersAreCut) {
  const GridMap map(Grid<CellState>(3, 3, CellState::free));
  EXPECT_FALSE(SweptDiagonal(FreeSpace(map), true).needed());
  EXPECT_FALSE(SweptDiagonal(FreeSpace(map, {.robot_radius = 1}), false).needed());
  EXPECT_TRUE(SweptDiagonal(FreeSpace(map, {.robot_radius = 1}), true).needed());
}

}  // namespace
}  // namespace wend
