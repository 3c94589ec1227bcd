#include "wend/geometry/direction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

Direction direction(int i) { return static_cast<Direction>(i); }

// Because of this fixed order, expansion orders are the same everywhere.
TEST(Direction, BeginsWithPlusYAndTurnsTowardsPlusX) {
  for (int i = 0; i < kDirections; ++i) {
    const Cell to = step({0, 0}, direction(i));
    EXPECT_NEAR(normalized_angle(std::atan2(to.y, to.x) - radians_from(90 - 45 * i)), 0, 1e-12)
        << i;
  }
  EXPECT_EQ(step({5, 5}, Direction::plus_y), (Cell{5, 6}));
  EXPECT_EQ(step({5, 5}, Direction::plus_x_minus_y), (Cell{6, 4}));
  EXPECT_EQ(step({5, 5}, Direction::minus_x_minus_y, 3), (Cell{2, 2}));
}

TEST(Direction, IsNearestToTheHeadingOfItsStep) {
  for (int i = 0; i < kDirections; ++i) {
    const Cell to = step({0, 0}, direction(i));
    const double heading = std::atan2(to.y, to.x);
    for (const double off : {-0.38, 0.0, 0.38, 2 * kPi}) {
      EXPECT_EQ(nearest_direction(heading + off), direction(i)) << i << " " << off;
    }
  }
}

TEST(Direction, ReachesAllEightNeighbours) {
  std::set<Cell> neighbours;
  for (int i = 0; i < kDirections; ++i) {
    const Cell to = step({3, -2}, direction(i));
    EXPECT_EQ(std::max(std::abs(to.x - 3), std::abs(to.y + 2)), 1);
    EXPECT_EQ(direction_of({to.x - 3, to.y + 2}), direction(i));
    neighbours.insert(to);
  }
  EXPECT_EQ(neighbours.size(), 8U);
}

TEST(Direction, IsDiagonalWhereBothCoordinatesChange) {
  for (int i = 0; i < kDirections; ++i) {
    const Cell to = step({0, 0}, direction(i));
    EXPECT_EQ(is_diagonal(direction(i)), to.x != 0 && to.y != 0) << i;
  }
}

TEST(Direction, OppositeLeadsBack) {
  for (int i = 0; i < kDirections; ++i) {
    const Cell there = step({7, 9}, direction(i));
    EXPECT_EQ(step(there, opposite(direction(i))), (Cell{7, 9})) << i;
    EXPECT_EQ(opposite(opposite(direction(i))), direction(i));
  }
}

TEST(Direction, NearestToANeighbourIsTheOneThatLeadsThere) {
  for (int i = 0; i < kDirections; ++i) {
    EXPECT_EQ(nearest_direction({7, 9}, step({7, 9}, direction(i))), direction(i));
  }
}

TEST(Direction, NearestToAFarCellIsWithinAnEighthOfATurn) {
  for (int x = -9; x <= 9; ++x) {
    for (int y = -9; y <= 9; ++y) {
      if (x == 0 && y == 0) continue;
      const Cell unit = step({0, 0}, nearest_direction({0, 0}, {x, y}));
      const double between = std::atan2(y, x) - std::atan2(unit.y, unit.x);
      EXPECT_LE(std::abs(normalized_angle(between)), kPi / 8 + 1e-12) << x << "," << y;
    }
  }
}

TEST(Heading, TurnsFromPlusXTowardsPlusY) {
  EXPECT_EQ(quarter_turned(Heading::plus_x), Heading::plus_y);
  EXPECT_EQ(quarter_turned(Heading::plus_y), Heading::minus_x);
  EXPECT_EQ(quarter_turned(Heading::minus_x), Heading::minus_y);
  EXPECT_EQ(quarter_turned(Heading::minus_y), Heading::plus_x);
  for (const Heading heading : kAllHeadings) {
    EXPECT_EQ(quarter_turned(quarter_turned(heading)), opposite(heading));
    EXPECT_EQ(opposite(opposite(heading)), heading);
    EXPECT_NE(opposite(heading), heading);
    EXPECT_EQ(is_along_x(heading), ahead(heading).x != 0);
  }
}

TEST(Heading, HasTheAngleOfItsStep) {
  EXPECT_EQ(ahead(Heading::minus_y), (Cell{0, -1}));
  EXPECT_EQ(ahead(Heading::plus_x), (Cell{1, 0}));
  for (const Heading heading : kAllHeadings) {
    const double angle = radians_of(heading);
    const Cell step = ahead(heading);
    EXPECT_NEAR(std::cos(angle), step.x, 1e-15);
    EXPECT_NEAR(std::sin(angle), step.y, 1e-15);
  }
}

TEST(Heading, IsTheNearestOne) {
  for (const Heading heading : kAllHeadings) {
    for (const double off : {-0.78, -0.3, 0.0, 0.78}) {
      for (const double turns : {-4 * kPi, 0.0, 2 * kPi}) {
        EXPECT_EQ(nearest_heading(radians_of(heading) + off + turns), heading) << off;
      }
    }
  }
}

TEST(Heading, IsExactOrNone) {
  for (const Heading heading : kAllHeadings) {
    const double angle = radians_of(heading);
    EXPECT_EQ(exact_heading(angle), heading);
    EXPECT_EQ(exact_heading(angle + 1e-9), std::nullopt);
    EXPECT_EQ(exact_heading(angle + 2 * kPi), std::nullopt);
  }
}

}  // namespace
}  // namespace wend
