#include "wend/space/lattice/car_lattice.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/testing/drawn_map.hpp"

namespace wend {
namespace {

TEST(CarPath, NamesTheMoveBetweenTwoPoses) {
  for (const Heading heading : kAllHeadings) {
    const CornerPose from{{4, 4}, heading};
    for (int number = 0; number < kCarMoves; ++number) {
      const auto move = static_cast<CarMove>(number);
      EXPECT_EQ(move_between(from, moved(from, move)), move);
    }
    EXPECT_EQ(move_between(from, from), std::nullopt);
    EXPECT_EQ(move_between(from, {{6, 4}, heading}), std::nullopt);
  }
}

TEST(CarPath, CostsWhatItsMovesDo) {
  const FreeSpace space = test::drawn_space("23.\n...");
  const std::vector<CornerPose> drive{{{0, 1}, Heading::minus_y},
                                      {{1, 0}, Heading::plus_x},    // around (1,1), over the 2
                                      {{2, 0}, Heading::plus_x},    // along the 3
                                      {{1, 1}, Heading::minus_y}};  // in reverse, over the 3
  const auto cost = [&](const CarDriving& driving) {
    return car_path_cost(CarLattice(space, driving), drive);
  };
  EXPECT_DOUBLE_EQ(cost({}), 2 * kPi / 2 + 1 + 3 * kPi / 2);
  EXPECT_DOUBLE_EQ(cost({.straight_terrain = StraightTerrain::mean}), 5 * kPi / 2 + 3);
  EXPECT_DOUBLE_EQ(cost({.reverse_factor = 2}), 2 * kPi / 2 + 1 + 6 * kPi / 2);
}

TEST(CarPath, OfOnePoseCostsNothing) {
  const CarLattice lattice(test::open_space(2, 2), {});
  EXPECT_EQ(car_path_cost(lattice, {}), 0);
  const std::vector<CornerPose> alone{{{1, 1}, Heading::minus_y}};
  EXPECT_EQ(car_path_cost(lattice, alone), 0);
}

}  // namespace
}  // namespace wend
