#include "wend/map/way_clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/testing/blocked_squares.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_map.hpp"
#include "wend/map/distance_field.hpp"
#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

constexpr double kExact = 1e-7;  // squared distances are multiples of 1/8 or of 1 / length^2

/// The least over all squares that count, by ternary search along the way.
double brute_force(const FreeSpace& space, Cell from, Cell to) {
  return test::least_distance_to_blocked(
      space, centre_of(from), [&](Cell cell) { return test::distance_to_square(from, to, cell); });
}

template <class Check>
void on_random_spaces(int count, Check&& check) {
  for (int seed = 1; seed <= count && !::testing::Test::HasFailure(); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map = test::random_map(random, random.between(1, 14), random.between(1, 14));
    const FreeSpace space(map, test::random_robot(random, map.frame().resolution));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    check(random, space);
  }
}

TEST(WayClearance, OfANeighbourIsTheDistanceOfTheWholeWay) {
  int nearer_in_the_middle = 0;
  on_random_spaces(50, [&](Random&, const FreeSpace& space) {
    for (const Cell from : test::all_cells(space.width(), space.height())) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell to{from.x + dx, from.y + dy};
          if (!space.contains(to)) continue;
          const double expected = brute_force(space, from, to);
          const std::uint32_t squared = squared_half_cell_way_clearance(space, from, to);
          if (expected == test::kInfinite) {
            ASSERT_EQ(squared, kNoObstacle);
            continue;
          }
          ASSERT_NEAR(std::sqrt(squared) / 2, expected, kExact)
              << from.x << "," << from.y << " to " << to.x << "," << to.y;
          const double at_ends = std::min(space.clearance(from), space.clearance(to));
          nearer_in_the_middle += expected > 0.1 && expected < at_ends - kExact ? 1 : 0;
        }
      }
    }
  });
  EXPECT_GT(nearer_in_the_middle, 50) << "too few gaps to say anything";
}

TEST(WayClearance, OfAnyTwoCellsIsTheDistanceOfTheWholeWay) {
  on_random_spaces(150, [](Random& random, const FreeSpace& space) {
    for (int i = 0; i < 20; ++i) {
      const Cell from = test::random_cell(random, space.width(), space.height());
      const Cell to = test::random_cell(random, space.width(), space.height());
      const double expected = brute_force(space, from, to);
      const double clearance = way_clearance(space, from, to);
      const double back = way_clearance(space, to, from);
      if (expected == test::kInfinite) {
        ASSERT_EQ(clearance, expected);
        ASSERT_EQ(back, expected);
      } else {
        ASSERT_NEAR(clearance, expected, kExact)
            << from.x << "," << from.y << " to " << to.x << "," << to.y;
        ASSERT_NEAR(clearance, back, kExact);
      }
    }
  });
}

/// So where no corner is cut the way of a disc along a diagonal step need not be looked at.
TEST(WayClearance, IsWideEnoughForAnyRobotThatMayStandOnAllFourCells) {
  on_random_spaces(400, [](Random&, const FreeSpace& space) {
    const auto& clearance = space.squared_half_cell_clearance();
    for (int y = 0; y + 1 < space.height(); ++y) {
      for (int x = 0; x + 1 < space.width(); ++x) {
        const std::uint32_t least = std::min({clearance[{x, y}], clearance[{x + 1, y}],
                                              clearance[{x, y + 1}], clearance[{x + 1, y + 1}]});
        ASSERT_GE(squared_half_cell_way_clearance(space, {x, y}, {x + 1, y + 1}), least);
        ASSERT_GE(squared_half_cell_way_clearance(space, {x + 1, y}, {x, y + 1}), least);
      }
    }
  });
}

TEST(WayClearance, IsNothingWhereACornerIsCut) {
  const FreeSpace space = test::drawn_space("...\n.#.\n...");
  EXPECT_EQ(squared_half_cell_way_clearance(space, {1, 0}, {2, 1}), 0U);
  EXPECT_EQ(squared_half_cell_way_clearance(space, {0, 0}, {1, 0}), 1U);
  EXPECT_EQ(way_clearance(space, {0, 0}, {2, 2}), 0);
  EXPECT_EQ(way_clearance(space, {0, 0}, {2, 0}), 0.5);
}

/// Between two corners: nearest in the middle, which no cell's clearance tells.
TEST(WayClearance, SeesTheMiddleOfAGap) {
  const FreeSpace space = test::drawn_space("#...\n....\n....\n...#");
  // The gap's corners are (1,1) and (3,3), the lattice corner between them is (2,2).
  EXPECT_EQ(squared_half_cell_way_clearance(space, {2, 1}, {1, 2}), 8U);
  EXPECT_DOUBLE_EQ(way_clearance(space, {1, 2}, {2, 1}), std::sqrt(2));
  EXPECT_DOUBLE_EQ(space.clearance({1, 2}), std::sqrt(10) / 2);
}

}  // namespace
}  // namespace wend
