#include "wend/robot/free_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "tests/testing/share.hpp"
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
  std::optional<OutsidePolicy> outside;

  FreeSpace space() const {
    return *make_free_space(
        map,
        {.footprint = Footprint::disc(radius_mm / 1000.0), .unknown = unknown, .outside = outside});
  }

  bool edge_counts() const {
    if (outside) return *outside == OutsidePolicy::blocked;
    return map.frame().metric;
  }

  bool is_obstacle(Cell cell) const {
    return map.state(cell) == CellState::occupied ||
           (map.state(cell) == CellState::unknown && unknown == UnknownPolicy::blocked);
  }

  /// Squared distance in half-cells from a cell's centre to the nearest of these closed squares; -1: none.
  template <class Counts>
  std::int64_t nearest(Cell from, Counts&& counts) const {
    std::int64_t least = -1;
    for (int y = -1; y <= map.height(); ++y) {
      for (int x = -1; x <= map.width(); ++x) {
        if (!counts(Cell{x, y})) continue;
        const std::int64_t dx = std::max(0, 2 * std::abs(x - from.x) - 1);
        const std::int64_t dy = std::max(0, 2 * std::abs(y - from.y) - 1);
        if (least < 0 || dx * dx + dy * dy < least) least = dx * dx + dy * dy;
      }
    }
    return least;
  }

  /// The distance to the nearest obstacle.
  std::int64_t nearest_obstacle(Cell from) const {
    return nearest(from, [&](Cell cell) { return map.contains(cell) && is_obstacle(cell); });
  }

  /// The distance to the nearest cell around the map.
  std::int64_t map_edge(Cell from) const {
    return nearest(from, [&](Cell cell) { return !map.contains(cell); });
  }

  /// The distance to the nearest of everything that blocks.
  std::int64_t nearest_blocked(Cell from) const {
    const std::int64_t obstacle = nearest_obstacle(from);
    if (!edge_counts()) return obstacle;
    return obstacle < 0 ? map_edge(from) : std::min(obstacle, map_edge(from));
  }

  /// Is distance >= radius? Both are squared and in half millimetres.
  bool may_stand_on(Cell cell) const {
    const std::int64_t squared = nearest_blocked(cell);
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
  frame.metric = random.chance(0.5);
  constexpr std::array<std::optional<OutsidePolicy>, 3> kOutside{
      std::nullopt, OutsidePolicy::blocked, OutsidePolicy::free};
  return {*make_grid_map(states, frame), resolution_mm, kRadii[random.below(kRadii.size())],
          random.chance(0.5) ? UnknownPolicy::blocked : UnknownPolicy::free,
          kOutside[random.below(kOutside.size())]};
}

template <class Check>
void for_random_samples(int count, Check&& check) {
  for (int seed = 0; seed < test::share_of(count); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Sample sample = random_sample(random);
    SCOPED_TRACE(testing::Message()
                 << "seed " << seed << ", " << sample.map.width() << " x " << sample.map.height()
                 << " cells of " << sample.resolution_mm << " mm, radius " << sample.radius_mm
                 << " mm, unknown cells "
                 << (sample.unknown == UnknownPolicy::blocked ? "blocked" : "free") << ", outside "
                 << (sample.edge_counts() ? "blocked" : "free"));
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
      const std::int64_t squared = sample.nearest_blocked(cell);
      if (squared < 0) {
        ASSERT_EQ(space.clearance(cell), std::numeric_limits<double>::infinity());
      } else {
        ASSERT_EQ(space.squared_half_cell_clearance()[cell], squared);
        ASSERT_DOUBLE_EQ(space.clearance(cell), std::sqrt(static_cast<double>(squared)) / 2);
      }
      ASSERT_EQ(space.obstacles().blocked()[cell], sample.is_obstacle(cell));
    }
  });
}

TEST(FreeSpace, SelectsTheCellsThatAreClear) {
  for_random_samples(200, [](const Sample& /*sample*/, const FreeSpace& space) {
    for (const double share : {0.0, 0.4, 0.8, 1.0}) {
      const double radius = share * space.radius_in_cells();
      const double least = 4 * radius * radius * (1 - 1e-9);
      const BitGrid clear = space.cells_clear_by(least);
      for (const Cell cell : test::all_cells(space.width(), space.height())) {
        const bool blocked = space.obstacles().blocked()[cell];
        ASSERT_EQ(clear[cell],
                  !blocked && space.squared_half_cell_clearance(cell, kNoObstacle) >= least);
      }
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
          const bool at_edge =
              sample.edge_counts() && sample.nearest_blocked(cell) == sample.map_edge(cell);
          expected = at_edge ? BlockReason::over_edge : BlockReason::too_close;
        }
        ASSERT_EQ(space.why_blocked(cell), expected) << x << "," << y;
        ASSERT_EQ(space.passable(cell), !expected.has_value());
      }
    }
  });
}

TEST(FreeSpace, HasTheRegionsOfItsPassableCells) {
  for_random_samples(50, [](const Sample&, const FreeSpace& space) {
    const ConnectedComponents expected(space.passable());
    for (const Cell cell : test::all_cells(space.width(), space.height())) {
      ASSERT_EQ(space.components().component(cell, Adjacency::edges),
                expected.component(cell, Adjacency::edges));
    }
  });
}

/// A row of free cells with one obstacle at its left end.
GridMap row_behind_an_obstacle(int width, double resolution) {
  Grid<CellState> states(width, 1, CellState::free);
  states[{0, 0}] = CellState::occupied;
  Frame frame;
  frame.resolution = resolution;
  return *make_grid_map(states, frame);
}

TEST(FreeSpace, LetsTheRobotTouchAnObstacle) {
  // The centre of cell 3 is 2.5 cells away from the obstacle.
  const GridMap map = row_behind_an_obstacle(8, 1);
  EXPECT_TRUE(make_free_space(map, {.footprint = Footprint::disc(2.5)})->passable({3, 0}));
  EXPECT_FALSE(make_free_space(map, {.footprint = Footprint::disc(2.5)})->passable({2, 0}));
  EXPECT_FALSE(make_free_space(map, {.footprint = Footprint::disc(2.5001)})->passable({3, 0}));
}

TEST(FreeSpace, ForgivesRoundingInARadiusInMetres) {
  // 0.25 m at 0.1 m a cell are 2.5 cells, even if 0.25 / 0.1 is rounded; likewise the others.
  struct Case {
    double radius;
    double resolution;
    int first_free;  // first cell whose centre is far enough
  };
  for (const Case& given : {Case{0.25, 0.1, 3}, Case{0.35, 0.1, 4}, Case{0.3, 0.1, 4},
                            Case{0.15, 0.1, 2}, Case{0.175, 0.05, 4}, Case{0.07, 0.02, 4},
                            Case{0.45, 0.3, 2}, Case{0.55, 0.1, 6}, Case{0.05, 0.1, 1}}) {
    SCOPED_TRACE(testing::Message() << given.radius << " m at " << given.resolution);
    const FreeSpace space = *make_free_space(row_behind_an_obstacle(12, given.resolution),
                                             {.footprint = Footprint::disc(given.radius)});
    EXPECT_FALSE(space.passable({given.first_free - 1, 0}));
    EXPECT_TRUE(space.passable({given.first_free, 0}));
    EXPECT_NEAR(space.radius_in_cells(), given.radius / given.resolution, 1e-12);
  }
}

TEST(FreeSpace, OfAPointIsEveryCellThatIsNoObstacle) {
  const FreeSpace space = *make_free_space(row_behind_an_obstacle(3, 1));
  EXPECT_FALSE(space.passable({0, 0}));
  EXPECT_TRUE(space.passable({1, 0}));
  EXPECT_EQ(space.why_blocked(Cell{1, 0}), std::nullopt);
}

TEST(FreeSpace, OfAMapInCellsIsNotNarrowedByTheMapsEdge) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(3, 3, CellState::free)),
                                           {.footprint = Footprint::disc(100)});
  EXPECT_EQ(space.outside(), OutsidePolicy::free);
  for (const Cell cell : test::all_cells(3, 3)) {
    EXPECT_TRUE(space.passable(cell));
    EXPECT_EQ(space.clearance(cell), std::numeric_limits<double>::infinity());
  }
  EXPECT_FALSE(space.passable({-1, 0}));
  EXPECT_EQ(space.why_blocked(Cell{3, 0}), BlockReason::outside);
}

TEST(FreeSpace, HasTheOptionsThatMakeItAgain) {
  const GridMap map = *make_grid_map(Grid<CellState>(5, 3, CellState::free), {.resolution = 0.1});
  const FreeSpaceOptions options{.footprint = Footprint::disc(0.15),
                                 .unknown = UnknownPolicy::free,
                                 .outside = OutsidePolicy::free,
                                 .clearance_distance = 0.2,
                                 .clearance_cost = 3,
                                 .primitives = *MotionPrimitives::turning_circle(1)};
  const FreeSpace space = *make_free_space(map, options);
  EXPECT_EQ(space.options(), options);
  EXPECT_EQ(make_free_space(map, space.options())->robot(), space.robot());
}

TEST(FreeSpace, OfAMapInMetresKeepsTheDiscOnTheMap) {
  const GridMap map =
      *make_grid_map(Grid<CellState>(5, 3, CellState::free), {.resolution = 0.1, .metric = true});
  const FreeSpace space = *make_free_space(map, {.footprint = Footprint::disc(0.15)});
  EXPECT_EQ(space.outside(), OutsidePolicy::blocked);
  EXPECT_EQ(space.options().outside, OutsidePolicy::blocked);
  EXPECT_EQ(space.passable().count(), 3U) << "the middle row, without its ends";
  EXPECT_EQ(space.clearance({2, 1}), 1.5);
  EXPECT_EQ(space.why_blocked(Cell{0, 1}), BlockReason::over_edge);
  EXPECT_EQ(describe(BlockReason::over_edge), "too close to the map's edge for the robot's radius");
  const FreeSpace hanging =
      *make_free_space(map, {.footprint = Footprint::disc(0.15), .outside = OutsidePolicy::free});
  EXPECT_EQ(hanging.passable().count(), map.size());
  EXPECT_EQ(make_free_space(map)->passable().count(), map.size()) << "a point fits in every cell";
}

TEST(FreeSpace, OfAVastRobotIsNothingNextToAnObstacle) {
  const FreeSpace space =
      *make_free_space(row_behind_an_obstacle(5, 0.01), {.footprint = Footprint::disc(1e9)});
  EXPECT_EQ(space.passable().count(), 0U);
  EXPECT_EQ(space.components().count(Adjacency::edges), 0U);
  EXPECT_FALSE(space.far_enough(kNoObstacle - 1.0));
  EXPECT_TRUE(space.far_enough(kNoObstacle)) << "without an obstacle every cell is far enough";
}

TEST(FreeSpace, JudgesOtherDistancesByTheSameRule) {
  const FreeSpace space =
      *make_free_space(row_behind_an_obstacle(5, 0.1), {.footprint = Footprint::disc(0.3)});
  EXPECT_TRUE(space.far_enough(36));  // 3 cells, squared, in half-cells
  EXPECT_FALSE(space.far_enough(35.99));
  const FreeSpace point = *make_free_space(row_behind_an_obstacle(5, 0.1));
  EXPECT_TRUE(point.far_enough(1));
  EXPECT_FALSE(point.far_enough(0));
  const FreeSpace small =
      *make_free_space(row_behind_an_obstacle(5, 0.1), {.footprint = Footprint::disc(0.03)});
  EXPECT_TRUE(small.far_enough(0.36)) << "0.3 cells from a point that is no cell's centre";
  EXPECT_FALSE(small.far_enough(0.35));
}

TEST(FreeSpace, HasTheMapsTerrain) {
  Grid<double> terrain(2, 1, 1);
  terrain[{1, 0}] = 3;
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(2, 1), {}, terrain));
  EXPECT_FALSE(space.uniform_terrain());
  EXPECT_EQ(space.terrain({1, 0}), 3);
  EXPECT_TRUE(make_free_space(*make_grid_map(Grid<CellState>(2, 1)))->uniform_terrain());
}

TEST(FreeSpace, SharesEverythingWithCopies) {
  const FreeSpace space = *make_free_space(row_behind_an_obstacle(5, 1));
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

TEST(FreeSpace, IsNotMadeForARobotThatCannotBe) {
  const GridMap map = *make_grid_map(Grid<CellState>(3, 2));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {nan, infinity, -0.1}) {
    const FreeSpaceOptions too_wide{.footprint = Footprint::disc(wrong)};
    const FreeSpaceOptions too_far{.clearance_distance = wrong};
    const FreeSpaceOptions too_dear{.clearance_cost = wrong};
    for (const auto& [options, where] :
         {std::pair(too_wide, "radius"), std::pair(too_far, "clearance_distance"),
          std::pair(too_dear, "clearance_cost")}) {
      const auto space = make_free_space(map, options);
      ASSERT_FALSE(space) << where << " " << wrong;
      EXPECT_EQ(space.error().status, Status::invalid_option);
      EXPECT_EQ(space.error().where, where);
      EXPECT_FALSE(make_free_space(Obstacles(map), options.robot()));
    }
  }
}

}  // namespace
}  // namespace wend
