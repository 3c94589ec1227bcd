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

TEST(Direction, GoesDownFirstAndThenCounterClockwiseAsDrawn) {
  for (const bool y_up : {false, true}) {
    for (int i = 0; i < kDirections; ++i) {
      SCOPED_TRACE(testing::Message() << "direction " << i << ", y_up " << y_up);
      const Cell to = step({0, 0}, direction(i), y_up);
      const double drawn_up = y_up ? to.y : -to.y;
      const double drawn_angle = std::atan2(drawn_up, to.x);
      EXPECT_NEAR(normalized_angle(drawn_angle - radians_from(-90 + 45 * i)), 0, 1e-12);
    }
  }
}

TEST(Direction, DownIsTheGreaterRowOnlyWhereYPointsDown) {
  EXPECT_EQ(step({5, 5}, Direction::down, false), (Cell{5, 6}));
  EXPECT_EQ(step({5, 5}, Direction::down, true), (Cell{5, 4}));
  EXPECT_EQ(step({5, 5}, Direction::up_left, false), (Cell{4, 4}));
  EXPECT_EQ(step({5, 5}, Direction::up_left, true), (Cell{4, 6}));
}

TEST(Direction, IsNearestToTheHeadingOfItsStep) {
  for (const bool y_up : {false, true}) {
    for (int i = 0; i < kDirections; ++i) {
      const Cell to = step({0, 0}, direction(i), y_up);
      const double heading = std::atan2(to.y, to.x);
      for (const double off : {-0.38, 0.0, 0.38, 2 * kPi}) {
        EXPECT_EQ(nearest_direction(heading + off, y_up), direction(i)) << i << " " << off;
      }
    }
  }
}

TEST(Direction, ReachesAllEightNeighbours) {
  for (const bool y_up : {false, true}) {
    std::set<Cell> neighbours;
    for (int i = 0; i < kDirections; ++i) {
      const Cell to = step({3, -2}, direction(i), y_up);
      EXPECT_EQ(std::max(std::abs(to.x - 3), std::abs(to.y + 2)), 1);
      neighbours.insert(to);
    }
    EXPECT_EQ(neighbours.size(), 8U);
  }
}

TEST(Direction, IsDiagonalWhereBothCoordinatesChange) {
  for (int i = 0; i < kDirections; ++i) {
    const Cell to = step({0, 0}, direction(i), false);
    EXPECT_EQ(is_diagonal(direction(i)), to.x != 0 && to.y != 0) << i;
  }
}

TEST(Direction, OppositeLeadsBack) {
  for (const bool y_up : {false, true}) {
    for (int i = 0; i < kDirections; ++i) {
      const Cell there = step({7, 9}, direction(i), y_up);
      EXPECT_EQ(step(there, opposite(direction(i)), y_up), (Cell{7, 9})) << i;
      EXPECT_EQ(opposite(opposite(direction(i))), direction(i));
    }
  }
}

TEST(Direction, NearestToANeighbourIsTheOneThatLeadsThere) {
  for (const bool y_up : {false, true}) {
    for (int i = 0; i < kDirections; ++i) {
      const Cell to = step({7, 9}, direction(i), y_up);
      EXPECT_EQ(nearest_direction({7, 9}, to, y_up), direction(i)) << "y_up " << y_up;
    }
  }
}

TEST(Direction, NearestToAFarCellIsWithinAnEighthOfATurn) {
  for (int x = -9; x <= 9; ++x) {
    for (int y = -9; y <= 9; ++y) {
      if (x == 0 && y == 0) continue;
      const auto nearest = nearest_direction({0, 0}, {x, y}, false);
      const Cell unit = step({0, 0}, nearest, false);
      const double between = std::atan2(y, x) - std::atan2(unit.y, unit.x);
      EXPECT_LE(std::abs(normalized_angle(between)), kPi / 8 + 1e-12) << x << "," << y;
    }
  }
}

}  // namespace
}  // namespace wend
