#include "wend/map/free_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "wend/map/distance_field.hpp"
#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

/// A map and a robot whose sizes are whole millimetres, so that the rule can be checked exactly.
struct Sample {
  GridMap map;
  int resolution_mm;
  int radius_mm;
  UnknownPolicy unknown;

  FreeSpace space() const {
    return FreeSpace(map, {.robot_radius = radius_mm / 1000.0, .unknown = unknown});
  }

  bool is_obstacle(Cell cell) const {
    return map.state(cell) == CellState::occupied ||
           (map.state(cell) == CellState::unknown && unknown == UnknownPolicy::blocked);
  }

  /// Squared, in half-cells, from a cell's centre to the nearest closed obstacle square; -1: none.
  std::int64_t nearest_obstacle(Cell from) const {
    std::int64_t least = -1;
    for (const Cell cell : test::all_cells(map.width(), map.height())) {
      if (!is_obstacle(cell)) continue;
      const std::int64_t dx = std::max(0, 2 * std::abs(cell.x - from.x) - 1);
      const std::int64_t dy = std::max(0, 2 * std::abs(cell.y - from.y) - 1);
      if (least < 0 || dx * dx + dy * dy < least) least = dx * dx + dy * dy;
    }
    return least;
  }

  /// distance >= radius, both squared and in half millimetres.
  bool may_stand_on(Cell cell) const {
    const std::int64_t squared = nearest_obstacle(cell);
    if (squared < 0) return true;
    return squared > 0 &&
           squared * resolution_mm * resolution_mm >= std::int64_t{4} * radius_mm * radius_mm;
  }
};

Sample random_sample(Random& random) {
  constexpr std::array kResolutions{1000, 100, 50, 25, 30};
  constexpr std::array kRadii{0, 0, 10, 25, 50, 75, 100, 150, 200, 250, 300, 350, 1000, 1500};
  const int width = random.chance(0.1) ? 1 : random.between(1, random.chance(0.2) ? 70 : 16);
  const int height = random.chance(0.1) ? 1 : random.between(1, 12);
  const double density = random.uniform() * random.uniform();
  Grid<CellState> states(width, height, CellState::free);
  for (const Cell cell : test::all_cells(width, height)) {
    if (random.chance(density)) {
      states[cell] = random.chance(0.5) ? CellState::occupied : CellState::unknown;
    }
  }
  const int resolution_mm = kResolutions[random.below(kResolutions.size())];
  Frame frame;
  frame.resolution = resolution_mm / 1000.0;
  return {GridMap(states, frame), resolution_mm, kRadii[random.below(kRadii.size())],
          random.chance(0.5) ? UnknownPolicy::blocked : UnknownPolicy::free};
}

template <class Check>
void for_random_samples(int count, Check&& check) {
  for (int seed = 0; seed < count; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Sample sample = random_sample(random);
    SCOPED_TRACE(testing::Message()
                 << "seed " << seed << ", " << sample.map.width() << " x " << sample.map.height()
                 << " cells of " << sample.resolution_mm << " mm, radius " << sample.radius_mm
                 << " mm, unknown cells "
                 << (sample.unknown == UnknownPolicy::blocked ? "blocked" : "free"));
    check(sample, sample.space());
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(FreeSpace, IsWhereTheRobotsDiscTouchesNoObstacleInside) {
  for_random_samples(400, [](const Sample& sample, const FreeSpace& space) {
    for (const Cell cell : test::all_cells(space.width(), space.height())) {
      ASSERT_EQ(space.passable(cell), sample.may_stand_on(cell)) << cell.x << "," << cell.y;
      ASSERT_EQ(space.passable()[cell], space.passable(cell));
    }
  });
}

TEST(FreeSpace, KnowsTheExactClearance) {
  for_random_samples(200, [](const Sample& sample, const FreeSpace& space) {
    for (const Cell cell : test::all_cells(space.width(), space.height())) {
      const std::int64_t squared = sample.nearest_obstacle(cell);
      if (squared < 0) {
        ASSERT_EQ(space.clearance(cell), std::numeric_limits<double>::infinity());
      } else {
        ASSERT_EQ(space.squared_half_cell_clearance()[cell], squared);
        ASSERT_DOUBLE_EQ(space.clearance(cell), std::sqrt(static_cast<double>(squared)) / 2);
      }
      ASSERT_EQ(space.obstacles()[cell], sample.is_obstacle(cell));
    }
  });
}

TEST(FreeSpace, SaysWhyACellIsBlocked) {
  for_random_samples(200, [](const Sample& sample, const FreeSpace& space) {
    for (int y = -1; y <= space.height(); ++y) {
      for (int x = -1; x <= space.width(); ++x) {
        const Cell cell{x, y};
        std::optional<BlockReason> expected;
        if (!sample.map.contains(cell)) {
          expected = BlockReason::outside;
        } else if (sample.is_obstacle(cell)) {
          expected = sample.map.state(cell) == CellState::unknown ? BlockReason::unknown
                                                                  : BlockReason::obstacle;
        } else if (!sample.may_stand_on(cell)) {
          expected = BlockReason::too_close;
        }
        ASSERT_EQ(space.why_blocked(cell), expected) << x << "," << y;
        ASSERT_EQ(space.passable(cell), !expected.has_value());
      }
    }
  });
}

TEST(FreeSpace, HasTheRegionsOfItsPassableCells) {
  for_random_samples(50, [](const Sample&, const FreeSpace& space) {
    const ConnectedRegions expected(space.passable());
    for (const Cell cell : test::all_cells(space.width(), space.height())) {
      ASSERT_EQ(space.regions().region(cell, Adjacency::edges),
                expected.region(cell, Adjacency::edges));
    }
  });
}

/// A row of free cells with one obstacle at its left end.
GridMap row_behind_an_obstacle(int width, double resolution) {
  Grid<CellState> states(width, 1, CellState::free);
  states[{0, 0}] = CellState::occupied;
  Frame frame;
  frame.resolution = resolution;
  return GridMap(states, frame);
}

TEST(FreeSpace, LetsTheRobotTouchAnObstacle) {
  // The centre of cell 3 is 2.5 cells away from the obstacle.
  const GridMap map = row_behind_an_obstacle(8, 1);
  EXPECT_TRUE(FreeSpace(map, {.robot_radius = 2.5}).passable({3, 0}));
  EXPECT_FALSE(FreeSpace(map, {.robot_radius = 2.5}).passable({2, 0}));
  EXPECT_FALSE(FreeSpace(map, {.robot_radius = 2.5001}).passable({3, 0}));
}

TEST(FreeSpace, ForgivesRoundingInARadiusInMetres) {
  // 0.25 m at 0.1 m a cell are 2.5 cells, whatever 0.25 / 0.1 is; likewise the others.
  struct Case {
    double radius;
    double resolution;
    int first_free;  // first cell whose centre is far enough
  };
  for (const Case& given : {Case{0.25, 0.1, 3}, Case{0.35, 0.1, 4}, Case{0.3, 0.1, 4},
                            Case{0.15, 0.1, 2}, Case{0.175, 0.05, 4}, Case{0.07, 0.02, 4},
                            Case{0.45, 0.3, 2}, Case{0.55, 0.1, 6}, Case{0.05, 0.1, 1}}) {
    SCOPED_TRACE(testing::Message() << given.radius << " m at " << given.resolution);
    const FreeSpace space(row_behind_an_obstacle(12, given.resolution),
                          {.robot_radius = given.radius});
    EXPECT_FALSE(space.passable({given.first_free - 1, 0}));
    EXPECT_TRUE(space.passable({given.first_free, 0}));
    EXPECT_NEAR(space.radius_in_cells(), given.radius / given.resolution, 1e-12);
  }
}

TEST(FreeSpace, OfAPointIsEveryCellThatIsNoObstacle) {
  const FreeSpace space(row_behind_an_obstacle(3, 1));
  EXPECT_FALSE(space.passable({0, 0}));
  EXPECT_TRUE(space.passable({1, 0}));
  EXPECT_EQ(space.why_blocked({1, 0}), std::nullopt);
}

TEST(FreeSpace, IsNotNarrowedByTheMapsEdge) {
  const FreeSpace space(GridMap(Grid<CellState>(3, 3, CellState::free)), {.robot_radius = 100});
  for (const Cell cell : test::all_cells(3, 3)) {
    EXPECT_TRUE(space.passable(cell));
    EXPECT_EQ(space.clearance(cell), std::numeric_limits<double>::infinity());
  }
  EXPECT_FALSE(space.passable({-1, 0}));
  EXPECT_EQ(space.why_blocked({3, 0}), BlockReason::outside);
}

TEST(FreeSpace, OfAVastRobotIsNothingNextToAnObstacle) {
  const FreeSpace space(row_behind_an_obstacle(5, 0.01), {.robot_radius = 1e9});
  EXPECT_EQ(space.passable().count(), 0U);
  EXPECT_EQ(space.regions().count(Adjacency::edges), 0U);
  EXPECT_FALSE(space.far_enough(kNoObstacle - 1.0));
  EXPECT_TRUE(space.far_enough(kNoObstacle)) << "where there is none it may stand";
}

TEST(FreeSpace, JudgesOtherDistancesByTheSameRule) {
  const FreeSpace space(row_behind_an_obstacle(5, 0.1), {.robot_radius = 0.3});
  EXPECT_TRUE(space.far_enough(36));  // 3 cells, squared, in half-cells
  EXPECT_FALSE(space.far_enough(35.99));
  const FreeSpace point(row_behind_an_obstacle(5, 0.1));
  EXPECT_TRUE(point.far_enough(1));
  EXPECT_FALSE(point.far_enough(0));
  const FreeSpace small(row_behind_an_obstacle(5, 0.1), {.robot_radius = 0.03});
  EXPECT_TRUE(small.far_enough(0.36)) << "0.3 cells from a point that is no cell's centre";
  EXPECT_FALSE(small.far_enough(0.35));
}

TEST(FreeSpace, HasTheMapsTerrain) {
  Grid<double> terrain(2, 1, 1);
  terrain[{1, 0}] = 3;
  const FreeSpace space(GridMap(Grid<CellState>(2, 1), {}, terrain));
  EXPECT_FALSE(space.uniform_terrain());
  EXPECT_EQ(space.terrain({1, 0}), 3);
  EXPECT_TRUE(FreeSpace(GridMap(Grid<CellState>(2, 1))).uniform_terrain());
}

TEST(FreeSpace, SharesEverythingWithCopies) {
  const FreeSpace space(row_behind_an_obstacle(5, 1));
  const FreeSpace copy =
      space;  // NOLINT(performance-unnecessary-copy-initialization): it is tested
  EXPECT_EQ(&copy.passable(), &space.passable());
}

TEST(BlockReason, IsSaidInWords) {
  EXPECT_EQ(describe(BlockReason::outside), "outside the map");
  EXPECT_EQ(describe(BlockReason::obstacle), "an obstacle");
  EXPECT_EQ(describe(BlockReason::unknown), "unknown");
  EXPECT_EQ(describe(BlockReason::too_close), "closer to an obstacle than the robot's radius");
}

}  // namespace
}  // namespace wend
