#include "wend/path/path_metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_map.hpp"
#include "tests/testing/textbook.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/direction.hpp"

namespace wend {
namespace {

PathMetrics on_open_ground(const std::vector<Cell>& cells) {
  return measure(Path(cells), test::open_space(20, 20));
}

double turning(const std::vector<Cell>& cells) { return on_open_ground(cells).turning; }

TEST(PathMetrics, TurningAddsUpTheChangesOfHeading) {
  EXPECT_EQ(turning({{3, 3}}), 0);
  EXPECT_EQ(turning({{3, 3}, {4, 3}}), 0);
  EXPECT_EQ(turning({{3, 3}, {4, 3}, {5, 3}}), 0);
  EXPECT_DOUBLE_EQ(turning({{3, 3}, {4, 3}, {4, 4}}), kPi / 2);
  EXPECT_DOUBLE_EQ(turning({{3, 3}, {4, 3}, {5, 4}}), kPi / 4);
  EXPECT_DOUBLE_EQ(turning({{3, 3}, {4, 4}, {5, 3}, {6, 4}}), kPi) << "left and right add up";
  EXPECT_DOUBLE_EQ(turning({{3, 3}, {4, 3}, {3, 4}}), kPi * 3 / 4);
}

TEST(PathMetrics, TurningBackIsHalfATurn) {
  EXPECT_DOUBLE_EQ(turning({{3, 3}, {4, 3}, {3, 3}}), kPi);
  EXPECT_DOUBLE_EQ(turning({{3, 3}, {3, 4}, {3, 3}, {3, 4}}), 2 * kPi);
  EXPECT_DOUBLE_EQ(turning({{4, 4}, {3, 3}, {4, 4}}), kPi);
}

TEST(PathMetrics, TurningOnceAroundIsAFullTurn) {
  std::vector<Cell> cells{{10, 10}};
  for (int i = 0; i <= kDirections; ++i) {
    cells.push_back(step(cells.back(), static_cast<Direction>(i % kDirections), false));
  }
  EXPECT_NEAR(turning(cells), 2 * kPi, 1e-12);
}

TEST(PathMetrics, StandingStillIsNoTurn) {
  EXPECT_DOUBLE_EQ(turning({{3, 3}, {4, 3}, {4, 3}, {4, 4}}), kPi / 2);
  EXPECT_EQ(turning({{3, 3}, {3, 3}, {4, 3}}), 0);
}

TEST(PathMetrics, WithoutObstaclesHasInfiniteClearance) {
  const PathMetrics metrics = on_open_ground({{0, 0}, {1, 1}, {2, 1}});
  EXPECT_EQ(metrics.smallest_clearance, test::kInfinite);
  EXPECT_EQ(metrics.mean_clearance, test::kInfinite);
  EXPECT_EQ(metrics.length, 1 + std::sqrt(2));
}

TEST(PathMetrics, WeighsClearanceByLength) {
  // From the obstacle the cells are 0.5, 1.5 and 2.5 away.
  const FreeSpace space = test::drawn_space("#...\n#...\n#...");
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}, {2, 0}, {3, 0}}), space).mean_clearance, 1.5);
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}, {2, 0}, {2, 1}}), space).mean_clearance, 1.25);
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}, {2, 1}, {2, 2}}), space).mean_clearance,
                   (std::sqrt(2) * 1 + 1.5) / (std::sqrt(2) + 1));
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}}), space).mean_clearance, 0.5);
  EXPECT_DOUBLE_EQ(measure(Path({{3, 0}, {3, 0}}), space).mean_clearance, 2.5);
}

TEST(PathMetrics, HasNoClearanceWhereItCutsACorner) {
  const FreeSpace space = test::drawn_space("...\n.#.\n...");
  EXPECT_EQ(measure(Path({{0, 0}, {1, 0}, {2, 1}}), space).smallest_clearance, 0);
  EXPECT_EQ(measure(Path({{0, 0}, {1, 0}, {2, 0}, {2, 1}}), space).smallest_clearance, 0.5);
}

/// A walk over the map, in steps to neighbours and, now and then, longer ones.
std::vector<Cell> random_walk(Random& random, const FreeSpace& space) {
  std::vector<Cell> cells{test::random_cell(random, space.width(), space.height())};
  for (int i = random.between(0, 12); i > 0; --i) {
    const auto direction = static_cast<Direction>(random.between(0, kDirections - 1));
    const Cell next = random.chance(0.1) ? test::random_cell(random, space.width(), space.height())
                                         : step(cells.back(), direction, false);
    if (space.contains(next)) cells.push_back(next);
  }
  return cells;
}

/// From a point to the nearest obstacle, over all there are.
double clearance_at(const FreeSpace& space, double x, double y) {
  double least = test::kInfinite;
  for (int row = 0; row < space.height(); ++row) {
    for (int column = 0; column < space.width(); ++column) {
      if (!space.obstacles()[{column, row}]) continue;
      least = std::min(least, test::distance_to_square(x, y, {column, row}));
    }
  }
  return least;
}

/// Densely sampled: never less than what is claimed, and down to it.
TEST(PathMetrics, SmallestClearanceIsThatOfTheNearestPoint) {
  constexpr int kSamples = 24;  // of a step; the middle is among them
  for (std::uint64_t seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 12), random.between(1, 12));
    const FreeSpace space(map, test::random_robot(random, map.frame().resolution));
    const std::vector<Cell> cells = random_walk(random, space);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    double least = clearance_at(space, cells[0].x + 0.5, cells[0].y + 0.5);
    double longest = 0;
    for (std::size_t i = 1; i < cells.size(); ++i) {
      const double dx = cells[i].x - cells[i - 1].x;
      const double dy = cells[i].y - cells[i - 1].y;
      longest = std::max(longest, std::hypot(dx, dy));
      for (int k = 0; k <= kSamples; ++k) {
        const double share = k / static_cast<double>(kSamples);
        least = std::min(least, clearance_at(space, cells[i - 1].x + 0.5 + share * dx,
                                             cells[i - 1].y + 0.5 + share * dy));
      }
    }
    const double smallest = measure(Path(cells), space).smallest_clearance;
    if (least == test::kInfinite) {
      ASSERT_EQ(smallest, least);
      continue;
    }
    ASSERT_LE(smallest, least + 1e-9);
    // Clearance changes by no more than the way to the next sample.
    const double sampling_error = longest < 1.5 ? 1e-9 : longest / kSamples / 2;
    ASSERT_GE(smallest, least - sampling_error);
  }
}

}  // namespace
}  // namespace wend
