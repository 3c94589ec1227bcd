#include "wend/path/smoothing/simplification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_path.hpp"
#include "tests/testing/sampled_robot.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/polyline.hpp"

namespace wend {
namespace {

/// A map, a robot, and a path on which it collides with nothing: a walk that likes to go straight on,
/// over cells or, moved a little where that is free, over any points.
struct FreeWalk {
  explicit FreeWalk(std::uint64_t seed)
      : random(seed),
        map(test::random_map(random, random.between(2, 20), random.between(2, 20))),
        robot(test::random_robot(random, map.frame().resolution)),
        space(*make_free_space(map, {.footprint = robot.footprint, .outside = robot.outside})),
        adjacency(random.chance(0.5) ? Adjacency::edges : Adjacency::edges_and_corners),
        path(walk()) {}

  bool is_free(const Path& way) const { return !first_collision(way, space, adjacency); }

  Path walk() {
    Path way({test::random_cell(random, map.width(), map.height())});
    if (!is_free(way)) return way;
    auto direction = Direction::plus_x;
    for (int i = random.between(0, 80); i > 0; --i) {
      if (random.chance(0.3)) {
        direction = static_cast<Direction>(random.between(0, kDirections - 1));
      }
      Path longer = way;
      longer.append(step(way.cells().back(), direction));
      if (is_free(longer)) way = longer;
    }
    return random.chance(0.5) ? way : shaken(way);
  }

  Path shaken(const Path& way) {
    std::vector<Point> points = way.points();
    for (Point& point : points) {
      const Point before = point;
      point = {point.x + test::number_between(random, -0.4, 0.4),
               point.y + test::number_between(random, -0.4, 0.4)};
      if (!is_free(Path::along(points))) point = before;
    }
    return Path::along(points);
  }

  Random random;
  GridMap map;
  FreeSpaceOptions robot;
  FreeSpace space;
  Adjacency adjacency;
  Path path;
};

/// Calls `check` on many walks that are free.
template <class Check>
void for_walks(const Check& check) {
  int walks = 0;
  for (std::uint64_t seed = 1; seed <= 400 && !testing::Test::HasFailure(); ++seed) {
    FreeWalk walk(seed);
    if (!walk.is_free(walk.path)) continue;
    ++walks;
    SCOPED_TRACE("seed " + std::to_string(seed) + ", radius " +
                 std::to_string(walk.space.radius_in_cells()) + "\n" + test::drawing_of(walk.map) +
                 test::text_of(walk.path));
    check(walk);
  }
  EXPECT_GT(walks, 150) << "too few walks to mean anything";
}

void expect_free(const FreeWalk& walk, const Path& path) {
  const test::SampledRobot robot(walk.map, walk.space.radius_in_cells(),
                                 walk.space.outside() == OutsidePolicy::blocked);
  for (const Arc& arc : path.arcs()) {
    const int steps = 1 + static_cast<int>(arc.length / 0.02);
    for (int i = 0; i <= steps; ++i) {
      ASSERT_FALSE(robot.collides_at(point_on(arc, arc.length * i / steps)));
    }
  }
  EXPECT_FALSE(first_collision(path, walk.space, walk.adjacency)) << "between two corners";
}

void expect_same_ends(const Path& path, const Path& other) {
  EXPECT_EQ(path.points().front(), other.points().front());
  EXPECT_EQ(path.points().back(), other.points().back());
}

TEST(WithoutCollinear, IsTheSameWay) {
  for_walks([](FreeWalk& walk) {
    const Path fewer = *without_collinear(walk.path);
    expect_same_ends(walk.path, fewer);
    ASSERT_NEAR(fewer.length(), walk.path.length(), 1e-7);
    const Polyline line = polyline_of(fewer);
    for (const Point point : walk.path.points()) {
      ASSERT_LT(line.nearest(point, 0, line.length()).distance, 1e-7);
    }
  });
}

TEST(WithoutCollinear, KeepsBendsAndWhereItTurnsBack) {
  EXPECT_EQ(*without_collinear(Path({{0, 0}, {1, 0}, {2, 0}, {3, 1}, {4, 2}, {3, 1}})),
            Path::along({{0.5, 0.5}, {2.5, 0.5}, {4.5, 2.5}, {3.5, 1.5}}));
  EXPECT_EQ(*without_collinear(Path({{3, 3}})), Path::along({{3.5, 3.5}}));
  EXPECT_EQ(*without_collinear(Path({{3, 3}, {3, 3}})), Path::along({{3.5, 3.5}}));
}

TEST(WithoutCollinear, KeepsAWayThatBendsEverSoLittle) {
  std::vector<Point> points;
  for (int i = 0; i <= 1000; ++i) points.push_back({i / 100.0, 1e-8 * (i / 100.0) * (i / 100.0)});
  const Path bend = Path::along(points);
  const Path fewer = *without_collinear(bend);
  EXPECT_LT(fewer.size(), bend.size() / 2);
  const Polyline line = polyline_of(fewer);
  for (const Point point : points) {
    EXPECT_LT(line.nearest(point, 0, line.length()).distance, 1e-8);
  }
}

TEST(Simplified, KeepsToItsToleranceAndStaysFree) {
  for_walks([](FreeWalk& walk) {
    const double tolerance = 0.6 * walk.random.between(0, 4);
    const Path fewer = *simplified(walk.path, tolerance, walk.space, walk.adjacency);
    expect_same_ends(walk.path, fewer);
    expect_free(walk, fewer);
    ASSERT_LE(fewer.size(), walk.path.size());
    ASSERT_LE(fewer.length(), walk.path.length() + 1e-9);
    const Polyline line = polyline_of(fewer);
    for (const Point point : walk.path.points()) {
      ASSERT_LE(line.nearest(point, 0, line.length()).distance, tolerance + 1e-9);
    }
  });
}

TEST(Simplified, OfAnOpenFieldIsALine) {
  const FreeSpace space = test::open_space(20, 20);
  const Path zigzag({{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}});
  EXPECT_EQ(*simplified(zigzag, 1, space), Path::along({{0.5, 0.5}, {4.5, 0.5}}));
  EXPECT_EQ(*simplified(zigzag, 0.99, space), Path::along({{0.5, 0.5}, {1.5, 1.5}, {4.5, 0.5}}))
      << "split where it is farthest off";
}

TEST(StringPulled, StaysFreeAndIsNeverLonger) {
  for_walks([](FreeWalk& walk) {
    const Path pulled = *string_pulled(walk.path, walk.space, walk.adjacency);
    expect_same_ends(walk.path, pulled);
    expect_free(walk, pulled);
    ASSERT_LE(pulled.length(), walk.path.length() + 1e-9);
    ASSERT_LE(pulled.length(), without_collinear(walk.path)->length() + 1e-9);
  });
}

TEST(StringPulled, GoesAroundACornerByOneBend) {
  const FreeSpace space = test::drawn_space(R"(
......
......
##....
......
......
)");
  const Path around({{0, 0}, {1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 4}, {0, 4}});
  EXPECT_EQ(*string_pulled(around, space), Path::along({{0.5, 0.5}, {3.5, 2.5}, {0.5, 4.5}}));
}

TEST(Resampled, IsEvenWhereThereIsRoomAndStaysFree) {
  for_walks([](FreeWalk& walk) {
    const double spacing = 0.2 + 0.5 * walk.random.between(0, 7);
    const Path even = *resampled(walk.path, spacing, walk.space, walk.adjacency);
    expect_same_ends(walk.path, even);
    expect_free(walk, even);
    const Polyline line = polyline_of(walk.path);
    for (const Point point : even.points()) {
      ASSERT_LT(line.nearest(point, 0, line.length()).distance, 1e-7) << "it is on the path";
    }
    if (line.length() == 0) return;
    const double pieces = std::max(1.0, std::round(line.length() / spacing));
    ASSERT_GE(static_cast<double>(even.size()), pieces);
    for (const Arc& arc : even.arcs()) ASSERT_LE(arc.length, line.length() / pieces + 1e-7);
  });
}

/// A path may come to where two obstacles touch and go back; a shortcut may not go on from there to
/// the other side.
TEST(Shortcuts, DoNotSqueezeThroughAGapThatThePathTouches) {
  const FreeSpace space = test::drawn_space(R"(
........
........
.....#..
...#....
....#...
........
)");
  const Path path = Path::along({{6.5, 3.9}, {4, 4}, {4.5, 1}, {2.5, 1.5}, {2.5, 4.5}});
  ASSERT_FALSE(first_collision(path, space));
  EXPECT_FALSE(first_collision(*string_pulled(path, space), space));
  EXPECT_FALSE(first_collision(*simplified(path, 9, space), space));
  EXPECT_EQ(*string_pulled(path, space, Adjacency::edges_and_corners),
            Path::along({{6.5, 3.9}, {4, 4}, {2.5, 4.5}}))
      << "who may squeeze does";
}

TEST(Resampled, CutsALineIntoEqualPieces) {
  const FreeSpace space = test::open_space(20, 20);
  const Path even = *resampled(Path({{0, 0}, {10, 0}}), 3, space);
  ASSERT_EQ(even.size(), 4U);
  for (const Arc& arc : even.arcs()) EXPECT_DOUBLE_EQ(arc.length, 10.0 / 3);
}

TEST(Resampled, DividesTheArcsOfADrive) {
  const FreeSpace space = test::open_space(20, 20);
  const Path drive = Path::through({{5, 5, 0}, {8, 8, kPi / 2}, {8, 6, kPi / 2}});
  const Path aside = Path::through({{0, 0, 0}, {0, 4, 0}});
  const Path steps = *resampled(aside, 1, space);
  for (const Pose& pose : steps.driven_poses()) EXPECT_EQ(pose.heading, 0);
  const Path even = *resampled(drive, 1, space);
  EXPECT_EQ(even.size(), 1U + 5 + 2);
  EXPECT_NEAR(even.length(), drive.length(), 1e-9);
  for (const Arc& arc : even.arcs()) {
    EXPECT_TRUE(std::abs(arc.curvature) < 1e-9 || std::abs(arc.curvature - 1.0 / 3) < 1e-9);
  }
}

}  // namespace
}  // namespace wend
