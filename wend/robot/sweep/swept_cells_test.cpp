// SweptCells against fits_along(), which asks the map itself.

#include "wend/robot/sweep/swept_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

constexpr int kSize = 24;

double between(Random& random, double least, double greatest) {
  return least + (greatest - least) * random.uniform();
}

GridMap map_of(BitGrid occupied) {
  BitGrid unknown(occupied.width(), occupied.height());
  return *make_grid_map(std::move(occupied), std::move(unknown));
}

GridMap with_obstacle(int width, int height, Cell cell) {
  BitGrid occupied(width, height);
  if (occupied.contains(cell)) occupied.set(cell, true);
  return map_of(std::move(occupied));
}

Footprint random_shape(Random& random, double grown) {
  const double length = between(random, 0.3, 3);
  const double width = between(random, 0.3, 2);
  const double ahead =
      between(random, -1, length + 1);  // of the front; the base point may be outside
  switch (random.below(4)) {
    case 0:
      return {};
    case 1:
      return Footprint::disc(length / 2 + grown);
    default:
      return *Footprint::polygon(*Polygon::make({{ahead + grown, width / 2 + grown},
                                                 {ahead - length - grown, width / 2 + grown},
                                                 {ahead - length - grown, -width / 2 - grown},
                                                 {ahead + grown, -width / 2 - grown}}));
  }
}

GridMap random_obstacles(Random& random) {
  BitGrid occupied(kSize, kSize);
  const double share = between(random, 0.01, 0.25);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) occupied.set({x, y}, random.chance(share));
  }
  return map_of(std::move(occupied));
}

/// Two segments from the middle of cell (0, 0).
std::vector<Pose> random_motion(Random& random) {
  std::vector<Pose> poses{{0.5, 0.5, between(random, -3, 3)}};
  for (int i = 0; i < 2; ++i) {
    const bool sideways = random.below(4) == 0;
    const double turn = random.below(3) == 0 ? 0 : between(random, -1.5, 1.5);
    const double length = random.below(5) == 0 ? 0 : between(random, -4, 4);
    const double course = sideways ? between(random, -1.5, 1.5) : 0;
    poses.push_back(end_of(Segment{poses.back(), length, turn, course}));
  }
  return poses;
}

std::vector<Pose> moved_to(std::vector<Pose> poses, Cell cell) {
  for (Pose& pose : poses) {
    pose.x += cell.x;
    pose.y += cell.y;
  }
  return poses;
}

bool map_says(const FreeSpace& space, const std::vector<Pose>& poses) {
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!fits_along(space, segment_between(poses[i - 1], poses[i]))) return false;
  }
  return true;
}

bool stays_on_map(const std::vector<Pose>& poses) {
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Segment segment = segment_between(poses[i - 1], poses[i]);
    for (int n = 0; n <= 100; ++n) {
      const Pose pose = pose_on(segment, n / 100.0);
      const double least = std::min({pose.x, pose.y, kSize - pose.x, kSize - pose.y});
      if (least < 0.01) return false;
    }
  }
  return true;
}

/// What fits by its cells fits by the map. What does not fit would not fit either if the robot were a
/// little larger: for discs by nothing, for polygons by the tolerance, for points by a hair.
TEST(SweptCellsTest, SayWhatTheMapSays) {
  int fitted = 0;
  int blocked = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(4000U) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GridMap map = random_obstacles(random);
    const OutsidePolicy outside =
        random.below(2) == 0 ? OutsidePolicy::blocked : OutsidePolicy::free;
    Random same = random;
    const FreeSpace space =
        *make_free_space(map, {.footprint = random_shape(random, 0), .outside = outside});
    Footprint larger = random_shape(same, space.outline() ? 0.1 : 0);
    if (space.is_point()) larger = Footprint::disc(1e-6);
    const FreeSpace grown = *make_free_space(map, {.footprint = larger, .outside = outside});
    const std::vector<Pose> motion = random_motion(random);
    const SweptCells swept(space, motion);
    for (int i = 0; i < 8; ++i) {
      const Cell from{static_cast<int>(random.below(kSize)), static_cast<int>(random.below(kSize))};
      const std::vector<Pose> here = moved_to(motion, from);
      if (fits(space, swept, from)) {
        ++fitted;
        EXPECT_TRUE(map_says(space, here));
      } else {
        ++blocked;
        EXPECT_FALSE(stays_on_map(here) && map_says(grown, here));
      }
    }
  }
  EXPECT_GT(fitted, test::share_of(2000));
  EXPECT_GT(blocked, test::share_of(2000));
}

TEST(SweptCellsTest, OfAPointAreTheCellsItTouches) {
  const FreeSpace space = *make_free_space(with_obstacle(8, 8, {-1, -1}));
  const SweptCells diagonal(space, std::vector<Pose>{{0.5, 0.5, 0}, {1.5, 1.5, 0}});
  ASSERT_EQ(diagonal.runs().size(), 2U);
  EXPECT_EQ(diagonal.runs()[0].cells, 3U) << "both cells beside the corner";
  EXPECT_EQ(diagonal.runs()[1].cells, 3U);
  const SweptCells straight(space, std::vector<Pose>{{0.5, 0.5, 0}, {3.5, 0.5, 0}});
  ASSERT_EQ(straight.runs().size(), 1U);
  EXPECT_EQ(straight.runs()[0].cells, 15U);
}

/// Wider than a word of 64 cells.
TEST(SweptCellsTest, OfALongMotionTakeSeveralRuns) {
  const FreeSpace empty = *make_free_space(with_obstacle(200, 5, {-1, -1}));
  const std::vector<Pose> far{{0.5, 0.5, 0}, {150.5, 0.5, 0}};
  EXPECT_TRUE(fits(empty, SweptCells(empty, far), {3, 2}));
  for (const int x : {3, 66, 67, 100, 153}) {
    const FreeSpace space = *make_free_space(with_obstacle(200, 5, {x, 2}));
    const SweptCells swept(space, far);
    EXPECT_FALSE(fits(space, swept, {3, 2})) << x;
    EXPECT_TRUE(fits(space, swept, {3, 1})) << x;
    EXPECT_FALSE(fits(space, swept, {60, 1})) << "it would leave the map";
  }
}

}  // namespace
}  // namespace wend
