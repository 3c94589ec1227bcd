#include "wend/space/lattice/car_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "tests/testing/drawn_map.hpp"

namespace wend {
namespace {

CarLattice lattice(std::string_view drawing, std::int64_t unit = 1, FreeSpaceOptions robot = {}) {
  return CarLattice(test::drawn_space(drawing, robot), {.unit = unit});
}

/// The ground of a move from a corner.
double ground(const CarLattice& lattice, Cell corner, Heading heading, CarMove move) {
  return lattice.ground({corner, heading}, move);
}

TEST(CarLattice, HasACornerMoreThanCells) {
  const CarLattice cells = lattice("...\n...");
  EXPECT_EQ(cells.columns(), 4);
  EXPECT_EQ(cells.rows(), 3);
  EXPECT_EQ(cells.passable().count(), 12U);
}

TEST(CarLattice, HasTheCornersThatAreMultiplesOfItsUnit) {
  const CarLattice wide = lattice(".......\n.......\n.......\n.......", 3);
  EXPECT_EQ(wide.columns(), 3);
  EXPECT_EQ(wide.rows(), 2);
  EXPECT_TRUE(has_room_for(wide.free_space().map(), {.unit = 4}));
  EXPECT_FALSE(has_room_for(wide.free_space().map(), {.unit = 5}));
}

TEST(CarLattice, CannotStandOnACornerThatAnObstacleTouches) {
  const CarLattice one = lattice("....\n.#..\n....");
  for (int y = 0; y < one.rows(); ++y) {
    for (int x = 0; x < one.columns(); ++x) {
      const bool touched = (x == 1 || x == 2) && (y == 1 || y == 2);
      EXPECT_EQ(one.passable({x, y}), !touched) << x << "," << y;
    }
  }
  EXPECT_FALSE(one.passable({-1, 0}));
  EXPECT_FALSE(one.passable({5, 0}));
}

/// If the map's edge cuts a lattice cell, its remaining part still blocks its corners.
TEST(CarLattice, BlocksACellThatAnyOfItsMapCellsBlocks) {
  const CarLattice wide = lattice(".......\n.......\n......#", 3);
  EXPECT_FALSE(wide.passable({2, 0}));
  EXPECT_FALSE(wide.passable({2, 1}));
  EXPECT_TRUE(wide.passable({1, 1}));
}

TEST(CarLattice, HasTheMeanTerrainOfItsMapCells) {
  const CarLattice wide = lattice("135\n139\n...", 2);
  EXPECT_EQ(wide.terrain()[(Cell{0, 0})], 2);
  EXPECT_EQ(wide.terrain()[(Cell{1, 0})], 7) << "of the two cells that the edge leaves";
  EXPECT_EQ(wide.terrain()[(Cell{0, 1})], 1);
  EXPECT_TRUE(lattice("...\n...", 2).terrain().empty());
}

TEST(CarLattice, LetsTurnsPayForTheCellThatTheySweep) {
  const CarLattice rough = lattice("2345\n6789");
  EXPECT_EQ(ground(rough, {1, 1}, Heading::plus_x, CarMove::fwd_minus), 3);
  EXPECT_EQ(ground(rough, {1, 1}, Heading::plus_x, CarMove::fwd_plus), 7);
  EXPECT_EQ(ground(rough, {1, 1}, Heading::plus_x, CarMove::rev_minus), 2);
  EXPECT_EQ(ground(rough, {1, 1}, Heading::plus_x, CarMove::rev_plus), 6);
  EXPECT_EQ(ground(rough, {1, 1}, Heading::minus_y, CarMove::fwd_minus), 2);
}

TEST(CarLattice, LetsStraightMovesPayForTheCellsBesideThem) {
  const FreeSpace space = test::drawn_space("2345\n6789");
  const auto along = [&](StraightTerrain pays, Cell corner, Heading heading) {
    const CarLattice rough(space, {.straight_terrain = pays});
    return ground(rough, corner, heading, CarMove::fwd);
  };
  EXPECT_EQ(along(StraightTerrain::none, {1, 1}, Heading::plus_x), 1);
  EXPECT_EQ(along(StraightTerrain::mean, {1, 1}, Heading::plus_x), 5) << "of 3 and 7";
  EXPECT_EQ(along(StraightTerrain::max, {1, 1}, Heading::plus_x), 7);
  EXPECT_EQ(along(StraightTerrain::mean, {1, 1}, Heading::plus_y), 6.5) << "of 6 and 7";
  EXPECT_EQ(along(StraightTerrain::max, {1, 0}, Heading::plus_y), 3);
  EXPECT_EQ(along(StraightTerrain::mean, {1, 0}, Heading::plus_x), 3) << "the one cell at the edge";
  EXPECT_EQ(along(StraightTerrain::max, {4, 1}, Heading::minus_y), 5);
}

TEST(CarLattice, SaysWhyACornerIsBlocked) {
  const CarLattice yard = lattice("...?\n#...\n....\n....");
  EXPECT_FALSE(yard.why_blocked({2, 3}));
  EXPECT_EQ(yard.why_blocked({5, 0})->reason, BlockReason::outside);
  EXPECT_EQ(yard.why_blocked({0, 2})->reason, BlockReason::obstacle);
  EXPECT_EQ(yard.why_blocked({0, 2})->cell, (Cell{0, 1}));
  EXPECT_EQ(yard.why_blocked({4, 1})->reason, BlockReason::unknown);
  EXPECT_EQ(yard.why_blocked({4, 1})->cell, (Cell{3, 0}));
  const CarLattice wide = lattice("....\n....\n....\n...#", 2);
  EXPECT_EQ(wide.why_blocked({1, 1})->cell, (Cell{3, 3}));
}

TEST(CarLattice, SaysHowNearAnObstacleIsToACornerThatIsTooClose) {
  const CarLattice yard = lattice("....\n....\n....\n...#", 1, {.footprint = Footprint::disc(1.5)});
  const auto fault = yard.why_blocked({2, 2});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->reason, BlockReason::too_close);
  EXPECT_FALSE(fault->cell);
  EXPECT_NEAR(fault->distance, std::sqrt(2), 1e-12);
  EXPECT_FALSE(yard.why_blocked({1, 1}));
}

/// Around the corner (0,0) the arc comes as near as sqrt(2) - 1 to the obstacle, whose distance to
/// both ends is 1; around (1,1) it stays at 1.
TEST(CarLattice, SweepsTheDiscAlongTheWholeArc) {
  const auto fits = [](double radius, Heading heading, CarMove move) {
    const CarLattice yard = lattice("...\n.#.\n...", 1, {.footprint = Footprint::disc(radius)});
    return yard.fits({1, 0}, yard.step(heading, move));
  };
  const double touching = std::sqrt(2) - 1;
  EXPECT_TRUE(fits(0.1, Heading::plus_y, CarMove::fwd_plus));
  EXPECT_TRUE(fits(touching, Heading::plus_y, CarMove::fwd_plus));
  EXPECT_FALSE(fits(touching + 1e-6, Heading::plus_y, CarMove::fwd_plus));
  EXPECT_TRUE(fits(touching + 1e-6, Heading::minus_x, CarMove::fwd_minus));
  EXPECT_TRUE(fits(1, Heading::minus_x, CarMove::fwd_minus));
  EXPECT_TRUE(fits(1, Heading::plus_x, CarMove::rev_plus)) << "the same arc, in reverse";
  EXPECT_TRUE(fits(1, Heading::minus_x, CarMove::fwd));
}

TEST(CarLattice, ConnectsWhatHeadingsAloneMightPart) {
  const CarLattice yard = lattice("..#..\n..#..\n..#..");
  EXPECT_TRUE(yard.connected({0, 0}, {1, 3}));
  EXPECT_FALSE(yard.connected({0, 0}, {4, 0}));
}

TEST(CarLattice, NamesPosesInGridCoordinates) {
  const CarLattice wide = lattice("......\n......\n......\n......", 2);
  for (const Heading heading : kAllHeadings) {
    const CornerPose place{{3, 1}, heading};
    EXPECT_EQ(wide.to_grid(place).point(), (Point{6, 2}));
    EXPECT_EQ(wide.nearest(wide.to_grid(place)), place);
  }
  EXPECT_EQ(wide.nearest({5.1, 0.9, 0.1})->vertex, (Cell{3, 0}));
}

}  // namespace
}  // namespace wend
