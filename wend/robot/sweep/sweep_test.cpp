#include "wend/robot/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_arc.hpp"

namespace wend {
namespace {

TEST(MapEdge, IsAsFarAsThePointThatLiesFarthestOut) {
  const FreeSpace space = test::open_space(10, 6);
  EXPECT_EQ(distance_inside(space, Point{3, 2}), 2);
  EXPECT_EQ(distance_inside(space, Point{9.5, 3}), 0.5);
  EXPECT_EQ(distance_inside(space, Point{11, 3}), -1);
  EXPECT_EQ(distance_inside(space, Line{{2, 3}, {6, 5.75}}), 0.25);
  // Half a circle around (5,3): its middle is farthest out.
  EXPECT_NEAR(distance_inside(space, Arc{{3, 3, -kPi / 2}, 2 * kPi, 0.5}), 1, 1e-12);
  EXPECT_NEAR(distance_inside(space, Arc{{5, 1, 0}, 2 * kPi, 0.5}), 1, 1e-12);
}

/// Never more than at any of many points, and equal to one of them.
TEST(MapEdge, OfAnArcIsThatOfItsPoints) {
  constexpr int kSamples = 200;
  for (std::uint64_t seed = 1; seed <= 2000 && !HasFailure(); ++seed) {
    Random random(seed);
    const FreeSpace space = test::open_space(random.between(1, 12), random.between(1, 12));
    const Arc arc = test::random_arc(random, space.width(), space.height());
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + test::text_of(arc));
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSamples; ++i) {
      const Point at = point_on(arc, arc.length * i / kSamples);
      for (const double gap : {at.x, space.width() - at.x, at.y, space.height() - at.y}) {
        least = std::min(least, gap);
      }
    }
    const double inside = distance_inside(space, arc);
    ASSERT_LE(inside, least + 1e-12);
    ASSERT_GE(inside, least - std::abs(arc.length) / kSamples / 2 - 1e-12);
  }
}

TEST(MapEdge, IsPartOfClearanceWhereTheOutsideIsBlocked) {
  const GridMap map = *make_grid_map(Grid<CellState>(10, 6, CellState::free));
  const FreeSpace blocked = *make_free_space(map, {.outside = OutsidePolicy::blocked});
  EXPECT_EQ(edge_clearance(blocked, Point{3, 2}), 2);
  EXPECT_EQ(edge_clearance(blocked, Point{-3, 2}), 0);
  EXPECT_EQ(edge_clearance(*make_free_space(map), Point{3, 2}),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace wend
