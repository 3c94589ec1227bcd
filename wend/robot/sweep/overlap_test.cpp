#include "wend/robot/sweep/overlap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/polygon_overlap.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"

namespace wend {
namespace {

GridMap random_blocks(Random& random) {
  Grid<CellState> states(14, 11, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(0.25)) states[cell] = CellState::occupied;
  }
  return *make_grid_map(states);
}

/// A pose whose base point is on the map.
Pose random_pose(Random& random, const GridMap& map) {
  return {map.width() * random.uniform(), map.height() * random.uniform(),
          (2 * random.uniform() - 1) * kPi};
}

double to_square(Point point, Cell cell) {
  const double dx = std::max({cell.x - point.x, point.x - cell.x - 1, 0.0});
  const double dy = std::max({cell.y - point.y, point.y - cell.y - 1, 0.0});
  return std::hypot(dx, dy);
}

/// The depth by its definition, over all cells.
double depth_of(const FreeSpace& space, Point point) {
  const BitGrid& blocked = space.obstacles().blocked();
  const double radius = space.radius_in_cells();
  double to_blocked = HUGE_VAL;
  double to_free = HUGE_VAL;
  for (const Cell cell : every_cell(blocked)) {
    double& least = blocked[cell] ? to_blocked : to_free;
    least = std::min(least, to_square(point, cell));
  }
  if (space.outside() == OutsidePolicy::blocked) {
    to_blocked =
        std::min({to_blocked, point.x, point.y, space.width() - point.x, space.height() - point.y});
  }
  const Cell cell = cell_at(point);
  return blocked[cell] ? radius + to_free : std::max(0.0, radius - to_blocked);
}

TEST(Overlap, OfADiscIsItsDepth) {
  for (std::uint64_t seed = 1; seed <= test::share_of(60U); ++seed) {
    Random random(seed);
    const auto outside = random.chance(0.5) ? OutsidePolicy::blocked : OutsidePolicy::free;
    const FreeSpace space =
        *make_free_space(random_blocks(random),
                         {.footprint = Footprint::disc(2 * random.uniform()), .outside = outside});
    for (int i = 0; i < 100; ++i) {
      const Pose pose = random_pose(random, space.map());
      const Overlap overlap = OverlapMeasure(space).at(pose);
      ASSERT_EQ(overlap.none(), space.fits(pose));
      ASSERT_NEAR(overlap.all, depth_of(space, pose.point()), 1e-9) << "seed " << seed;
      ASSERT_EQ(overlap.all, overlap.obstacles);
    }
  }
}

TEST(Overlap, OfAPolygonIsItsArea) {
  for (std::uint64_t seed = 1; seed <= test::share_of(40U); ++seed) {
    Random random(seed);
    const Footprint box = *Footprint::polygon(
        *Polygon::make({{1.5 + random.uniform(), 0.7}, {-0.6, 0.9}, {-0.4, -1.1}, {1.2, -0.5}}));
    const auto outside = random.chance(0.5) ? OutsidePolicy::blocked : OutsidePolicy::free;
    const FreeSpace space =
        *make_free_space(random_blocks(random), {.footprint = box, .outside = outside});
    const auto squares = test::blocked_squares(space);
    for (int i = 0; i < 100; ++i) {
      const Pose pose = random_pose(random, space.map());
      const auto corners = test::corners_at(*space.outline(), pose);
      double area = 0;
      for (const Cell square : squares) area += test::common_area(corners, square);
      const Overlap overlap = OverlapMeasure(space).at(pose);
      ASSERT_EQ(overlap.none(), space.fits(pose));
      ASSERT_NEAR(overlap.all, area, 1e-7) << "seed " << seed;
    }
  }
}

TEST(Overlap, TellsZonesFromObstacles) {
  GridMap map = test::drawn_map(
      "......\n"
      "..###.\n"
      "......\n");
  BitGrid zone(6, 3);
  zone.set({2, 1}, true);
  zone.set({3, 1}, true);
  map.add_zone({"zone", zone});
  const FreeSpace space = *make_free_space(map);
  const OverlapMeasure measure(space);
  const Overlap in_zone = measure.at({2.5, 1.5, 0});
  EXPECT_GT(in_zone.all, 0);
  EXPECT_EQ(in_zone.obstacles, 0);
  const Overlap in_wall = measure.at({4.5, 1.5, 0});
  EXPECT_EQ(in_wall.obstacles, in_wall.all);
  EXPECT_TRUE(in_wall.exceeds(in_zone));
  EXPECT_TRUE(measure.at({0.5, 0.5, 0}).none());
  const Overlap off_map = measure.at({-1, 0.5, 0});
  EXPECT_TRUE(off_map.exceeds(in_wall));
  EXPECT_TRUE(off_map.exceeds(off_map)) << "nothing leads there";
}

}  // namespace
}  // namespace wend
