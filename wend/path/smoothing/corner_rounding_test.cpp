#include "wend/path/smoothing/corner_rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_path.hpp"
#include "tests/testing/share.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/polyline.hpp"
#include "wend/path/trajectory.hpp"

namespace wend {
namespace {

const Path kBent = Path::along({{1, 1}, {4, 1}, {4, 5}});

TEST(CornerRounding, ReplacesACornerByItsWidestArc) {
  const FreeSpace space = test::open_space(9, 9);
  const Path rounded = *rounded_corners(kBent, space, 0.1);
  const auto arcs = rounded.arcs();
  ASSERT_EQ(arcs.size(), 3U);
  EXPECT_NEAR(1 / arcs[1].curvature, 0.1 / (std::sqrt(2) - 1), 1e-9);
  EXPECT_NEAR(arcs[1].turn(), kPi / 2, 1e-9);
  EXPECT_EQ(rounded.points().front(), (Point{1, 1}));
  EXPECT_EQ(rounded.points().back(), (Point{4, 5}));
}

TEST(CornerRounding, KeepsACornerThatHasNoRoomOrNoWindow) {
  const auto corner_of = [](const Path& path) { return path.segments().at(1); };
  const FreeSpace open = test::open_space(9, 9);
  const Segment sharp = corner_of(*rounded_corners(kBent, open, 0));
  EXPECT_EQ(sharp.length, 0);
  EXPECT_NEAR(sharp.turn, kPi / 2, 1e-12);
  // Around the corner (4,1) of a blocked cell: an arc would cut it.
  const FreeSpace space = test::drawn_space(
      ".........\n"
      "...#.....\n"
      ".........\n"
      ".........");
  const Path taut = Path::along({{1, 1}, {4, 1}, {4, 3}});
  ASSERT_FALSE(first_collision(taut, space));
  EXPECT_EQ(corner_of(*rounded_corners(taut, space, 0.1)).length, 0);
  const Segment back = corner_of(*rounded_corners(Path::along({{1, 1}, {4, 1}, {2, 1}}), open, 1));
  EXPECT_EQ(back.length, 0);
}

TEST(CornerRounding, OfAPointOrADriveChangesNothing) {
  const FreeSpace space = test::open_space(9, 9);
  EXPECT_EQ(rounded_corners(Path({Cell{2, 2}}), space, 0.1)->poses(),
            (std::vector<Pose>{{2.5, 2.5, 0}}));
  const Path drive = Path::through({{1, 1, 0}, {2, 2, kPi / 2}});
  EXPECT_EQ(*rounded_corners(drive, space, 0.1), drive);
}

/// Where a path turns back but for rounding, an arc would be a stop before its end.
TEST(CornerRounding, LeavesWherePathsTurnBack) {
  const Point end{7.3, 4.1};
  const Path path = Path::along({{1.2, 2.3}, end, {1.2 + 1e-14, 2.3}});
  const Path rounded = *rounded_corners(path, test::open_space(20, 15), 0.3);
  ASSERT_EQ(rounded.size(), 4U);
  EXPECT_EQ(rounded.points()[1], end);
  EXPECT_EQ(rounded.points()[2], end);
}

TEST(CornerRounding, StaysFreeAndWithinTheWindowAndCanBeTimed) {
  for (std::uint64_t seed = 0; seed < test::share_of(100U); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GridMap map = test::random_map(random, 20, 15);
    const FreeSpace space =
        *make_free_space(map, test::random_robot(random, map.frame().resolution));
    const Path path = test::random_free_path(random, space, Adjacency::edges);
    if (path.empty()) continue;
    constexpr double kWindow = 0.2;
    const Path rounded = *rounded_corners(path, space, kWindow);
    EXPECT_FALSE(first_collision(rounded, space));
    const Polyline line = polyline_of(path);
    const Polyline curve = polyline_of(rounded);
    for (const Point point : curve.points()) {
      EXPECT_LE(line.nearest(point, 0, line.length()).distance, kWindow + 1e-9);
    }
    const auto sharp = Trajectory::along(path, space.map().frame());
    const auto smooth = Trajectory::along(rounded, space.map().frame());
    ASSERT_TRUE(sharp && smooth);
    EXPECT_LE(smooth->duration(), sharp->duration() + 1e-9);
  }
}

}  // namespace
}  // namespace wend
