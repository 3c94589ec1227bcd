// tests/lattice/car_heuristic_test.cpp shows that the estimates are consistent, and which are exact.

#include "wend/space/lattice/car_heuristic.hpp"

#include <gtest/gtest.h>

#include "wend/space/lattice/car_space.hpp"

namespace wend {
namespace {

using Costs = RealCarCosts;

double headings(const CornerPose& from, const CarGoal& goal) {
  return headings_estimate<Costs>(from, goal);
}

TEST(CarHeuristic, DiagonalCountsATurnForEachDiagonalCell) {
  EXPECT_DOUBLE_EQ(diagonal_estimate<Costs>({0, 0}, {5, 2}), 2 * kPi / 2 + 3);
  EXPECT_DOUBLE_EQ(diagonal_estimate<Costs>({4, 9}, {4, 2}), 7);
  EXPECT_DOUBLE_EQ(diagonal_estimate<Costs>({0, 0}, {-18, 18}), 9 * kPi);
}

TEST(CarHeuristic, HeadingsKnowsHowACarMustFace) {
  const CornerPose start{{0, 0}, Heading::plus_x};
  EXPECT_DOUBLE_EQ(headings(start, {{3, 0}, Heading::plus_x}), 3);
  EXPECT_DOUBLE_EQ(headings(start, {{-3, 0}, Heading::plus_x}), 3) << "in reverse";
  EXPECT_DOUBLE_EQ(headings(start, {{1, 1}, Heading::plus_y}), kPi / 2);
  EXPECT_DOUBLE_EQ(headings(start, {{2, 2}, Heading::plus_x}), kPi);
  EXPECT_DOUBLE_EQ(headings(start, {{0, 1}, Heading::plus_x}), kPi + 1) << "there and back";
  EXPECT_DOUBLE_EQ(headings(start, {{0, 0}, Heading::minus_x}), kPi + 2)
      << "in three moves or more";
}

TEST(CarHeuristic, HeadingsTakesTheBestOfAnyHeading) {
  const CornerPose start{{0, 0}, Heading::plus_x};
  EXPECT_DOUBLE_EQ(headings(start, {{3, 1}}), kPi / 2 + 2);
  EXPECT_DOUBLE_EQ(headings(start, {{0, 1}}), kPi / 2 + 1) << "one turn, and back along its side";
  EXPECT_EQ(headings(start, {{0, 0}}), 0);
}

TEST(CarHeuristic, HeadingsKnowsTheSideOfATurn) {
  EXPECT_DOUBLE_EQ(headings({{0, 5}, Heading::plus_x}, {{1, 4}, Heading::minus_y}), kPi / 2);
  EXPECT_GT(headings({{0, 4}, Heading::plus_x}, {{1, 5}, Heading::minus_y}), kPi);
}

TEST(CarHeuristic, IsTheSameInWholeNumbers) {
  for (int dx = -6; dx <= 6; ++dx) {
    for (int dy = -6; dy <= 6; ++dy) {
      for (const Heading from : kAllHeadings) {
        for (const Heading to : kAllHeadings) {
          const CornerPose start{{0, 0}, from};
          const CarGoal goal{{dx, dy}, to};
          const double real = headings(start, goal);
          const auto whole = headings_estimate<CompactCarCosts>(start, goal);
          EXPECT_NEAR(static_cast<double>(whole) / CompactCarCosts::kUnitsPerCell, real, 1e-8);
        }
      }
    }
  }
}

TEST(CarGoal, ContainsOnePoseOrAllOfACorner) {
  const CarGoal goal{{2, 3}, Heading::minus_x};
  EXPECT_TRUE(goal.contains({{2, 3}, Heading::minus_x}));
  EXPECT_FALSE(goal.contains({{2, 3}, Heading::plus_x}));
  EXPECT_FALSE(goal.contains({{3, 3}, Heading::minus_x}));
  const CarGoal any{{2, 3}, std::nullopt};
  for (const Heading heading : kAllHeadings) EXPECT_TRUE(any.contains({{2, 3}, heading}));
}

}  // namespace
}  // namespace wend
