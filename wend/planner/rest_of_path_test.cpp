// What is left of a path, beside places that are looked for step by step.

#include "wend/planner/rest_of_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/testing/random_cells.hpp"
#include "tests/testing/random_path.hpp"
#include "tests/testing/share.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

FreeSpace space_of(const BitGrid& free) {
  Grid<CellState> cells(free.width(), free.height(), CellState::occupied);
  for (const Cell cell : every_cell(free)) {
    if (free[cell]) cells[cell] = CellState::free;
  }
  return *make_free_space(*make_grid_map(cells));
}

/// A walk of legal steps, which may cross itself; empty where no cell is free.
std::vector<Cell> random_walk_on(const FreeSpace& space, GridMoves moves, Random& random) {
  std::vector<Cell> walk;
  for (int tries = 0; tries < 50 && walk.empty(); ++tries) {
    const Cell cell = test::random_cell(random, space.width(), space.height());
    if (space.passable()[cell]) walk.push_back(cell);
  }
  for (int steps = random.between(0, 25); steps > 0 && !walk.empty(); --steps) {
    const Cell next = step(walk.back(), static_cast<Direction>(random.between(0, kDirections - 1)));
    const std::vector<Cell> taken{walk.back(), next};
    if (check_grid_path(space, moves, taken)) walk.push_back(next);
  }
  return walk;
}

std::int64_t squared(Cell a, Cell b) {
  const std::int64_t dx = a.x - b.x;
  const std::int64_t dy = a.y - b.y;
  return dx * dx + dy * dy;
}

TEST(RestOfSteps, BeginsAtTheRobotAndFollowsTheRestLegally) {
  int found = 0;
  for (int seed = 1; seed <= test::share_of(2000) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const FreeSpace space = space_of(test::random_cells(random, 12, 0.6));
    GridMoves moves;
    if (random.chance(0.3)) moves.connectivity = Connectivity::four;
    const std::vector<Cell> walk = random_walk_on(space, moves, random);
    if (walk.empty()) continue;
    const Cell robot = random.chance(0.3)
                           ? walk[random.below(walk.size())]
                           : test::random_cell(random, space.width(), space.height());
    const std::size_t before = random.below(walk.size());
    std::size_t passed = before;
    const auto rest = rest_of_steps(space, moves, walk, Query::between(robot, walk.back()), passed);
    ASSERT_GE(passed, before);
    for (std::size_t i = before; i < walk.size(); ++i) {
      const bool is_nearer = i < passed ? squared(walk[i], robot) <= squared(walk[passed], robot)
                                        : squared(walk[i], robot) < squared(walk[passed], robot);
      ASSERT_FALSE(is_nearer) << "cell " << i << " is nearer than cell " << passed;
    }
    const std::vector<Cell> tail(walk.begin() + static_cast<std::ptrdiff_t>(passed), walk.end());
    if (robot == tail.front()) {
      ASSERT_TRUE(rest);
      ASSERT_EQ(rest->path.cells().size(), tail.size());
    }
    if (!rest) continue;
    ++found;
    ASSERT_EQ(rest->path.cells().front(), robot);
    ASSERT_EQ(rest->path.cells().back(), walk.back());
    const auto cost = check_grid_path(space, moves, rest->path.cells());
    ASSERT_TRUE(cost);
    ASSERT_EQ(*cost, rest->cost);
    // Straight to the nearest cell is one of the ways that are compared.
    if (squared(robot, tail.front()) > 2) continue;
    std::vector<Cell> joined{robot};
    if (robot != tail.front()) joined.insert(joined.end(), tail.begin(), tail.end());
    if (const auto its_cost = check_grid_path(space, moves, joined);
        its_cost && joined.size() > 1) {
      ASSERT_LE(rest->cost, *its_cost * (1 + 1e-9));
    }
  }
  EXPECT_GT(found, 100);
}

/// Where a radian counts as a cell.
double difference(const Pose& a, const Pose& b) {
  return std::hypot(std::hypot(a.x - b.x, a.y - b.y), normalized_angle(a.heading - b.heading));
}

TEST(NearestOnDrive, NoSampleOfTheDriveIsNearer) {
  for (int seed = 1; seed <= test::share_of(1000) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const Path path = test::random_drive(random, 20, 20);
    const JoinedPoses drive(path.driven_poses());
    const Pose robot{20 * random.uniform(), 20 * random.uniform(), 7 * random.uniform()};
    const std::size_t from = random.below(drive.poses().size());
    const PlaceOnDrive place = nearest_on_drive(drive, robot, from);
    ASSERT_GE(place.joint, from);
    ASSERT_TRUE(place.share >= 0 && place.share < 1);
    const Pose expected = place.share == 0 ? drive.poses()[place.joint]
                                           : pose_on(drive.segment(place.joint), place.share);
    ASSERT_LT(difference(place.pose, expected), 1e-9);
    ASSERT_NEAR(place.distance, std::hypot(place.pose.x - robot.x, place.pose.y - robot.y), 1e-9);
    ASSERT_NEAR(place.turn, std::abs(normalized_angle(place.pose.heading - robot.heading)), 1e-9);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = from; i < drive.segment_count(); ++i) {
      for (int k = 0; k <= 200; ++k) {
        least = std::min(least, difference(pose_on(drive.segment(i), k / 200.0), robot));
      }
    }
    // It looks every half cell, and from there for the lowest point near by.
    ASSERT_LT(difference(place.pose, robot), least + 0.1);
  }
}

}  // namespace
}  // namespace wend
