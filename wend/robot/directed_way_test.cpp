#include "wend/robot/directed_way.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "conformance/random_directions.hpp"

namespace wend {
namespace {

GridMap open_ground(int width, int height) {
  return *make_grid_map(Grid<CellState>(width, height, CellState::free));
}

Point random_point(Random& random, const FreeSpace& space) {
  return {space.width() * random.uniform(), space.height() * random.uniform()};
}

/// By 4,000 points of the line.
bool is_allowed(const FreeSpace& space, const Line& line) {
  constexpr int kPoints = 4000;
  for (int i = 0; i < kPoints; ++i) {
    const Cell cell = cell_at(line.at((i + 0.5) / kPoints));
    if (std::isinf(space.directions()->rule(cell).factor(line.heading()))) return false;
  }
  return true;
}

TEST(DirectedWay, ALineIsJudgedInEachCellThatItCrosses) {
  int forbidden = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const FreeSpace space =
        *make_free_space(test::with_random_directions(random, open_ground(7, 5)));
    const Line line{random_point(random, space), random_point(random, space)};
    EXPECT_EQ(may_go_along(space, line), is_allowed(space, line));
    forbidden += may_go_along(space, line) ? 0 : 1;
  }
  EXPECT_GT(forbidden, 30);
}

TEST(DirectedWay, TheEdgeOfTheMapBelongsToTheCellInside) {
  const FreeSpace space =
      *make_free_space(*with_arrows(open_ground(1, 3), Grid<double>(1, 3, kPi / 2)));
  for (const double x : {0.0, 0.5, 1.0}) {
    EXPECT_TRUE(may_go_along(space, Line{{x, 0}, {x, 3}}));
    EXPECT_FALSE(may_go_along(space, Line{{x, 3}, {x, 0}}));
  }
}

TEST(DirectedWay, PartsAddUpToTheLine) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const FreeSpace space = *make_free_space(open_ground(9, 6));
    const auto middle = [&](int most) { return random.between(0, most - 1) + 0.5; };
    const bool centres = random.chance(0.5);
    const Line line = centres ? Line{{middle(9), middle(6)}, {middle(9), middle(6)}}
                              : Line{random_point(random, space), random_point(random, space)};
    double length = 0;
    for_each_part(space, line, [&](const WayPart& part) {
      length += part.length;
      return true;
    });
    EXPECT_NEAR(length, line.length(), 1e-4);
  }
}

TEST(DirectedWay, AStepIsJudgedByBothOfItsCells) {
  Grid<double> headings(3, 1, std::numeric_limits<double>::quiet_NaN());
  headings[{1, 0}] = 0;
  const FreeSpace space = *make_free_space(*with_arrows(open_ground(3, 1), headings));
  EXPECT_TRUE(may_step(space, {0, 0}, {1, 0}));
  EXPECT_TRUE(may_step(space, {1, 0}, {2, 0}));
  EXPECT_FALSE(may_step(space, {2, 0}, {1, 0})) << "it enters";
  EXPECT_FALSE(may_step(space, {1, 0}, {0, 0})) << "it leaves";
}

TEST(DirectedWay, WhatCountsIsWhereTheRobotMoves) {
  const FreeSpace space =
      *make_free_space(*with_arrows(open_ground(8, 8), Grid<double>(8, 8, 0.0)));
  EXPECT_TRUE(may_go_along(space, Segment{{1, 4, 0}, 3, 0, 0}));
  EXPECT_FALSE(may_go_along(space, Segment{{4, 4, 0}, -3, 0, 0})) << "in reverse";
  EXPECT_TRUE(may_go_along(space, Segment{{1, 4, kPi}, -3, 0, 0})) << "backs along the arrow";
  EXPECT_FALSE(may_go_along(space, Arc{{4, 2, 0}, kPi * 2, 0.5})) << "a half circle and more";
  EXPECT_TRUE(may_go_along(space, Arc{{4, 2, 0}, kPi / 2, 1})) << "a quarter: across at its end";
  EXPECT_TRUE(may_go_along(space, Segment{{4, 4, 0}, 0, kPi, 0})) << "turns in place";
}

TEST(AgainstArrows, OverlooksAnEighthOfACell) {
  Grid<double> headings(4, 1, std::numeric_limits<double>::quiet_NaN());
  headings[{2, 0}] = kPi;
  const FreeSpace space = *make_free_space(*with_arrows(open_ground(4, 1), headings));
  EXPECT_TRUE(AgainstArrows().go_along(space, Line{{1, 0.5}, {2.1, 0.5}}));
  AgainstArrows in_pieces;
  EXPECT_TRUE(in_pieces.go_along(space, Line{{1, 0.5}, {2.1, 0.5}}));
  EXPECT_FALSE(in_pieces.go_along(space, Line{{2.1, 0.5}, {2.2, 0.5}})) << "pieces add up";
  EXPECT_FALSE(may_go_along(space, Line{{1, 0.5}, {2.1, 0.5}})) << "planners overlook nothing";
}

}  // namespace
}  // namespace wend
