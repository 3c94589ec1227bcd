#include "wend/robot/sweep/fits_along.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/polygon_overlap.hpp"
#include "tests/testing/random_polygon.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

// A smaller area is rounding, possibly of a corner that enters a square a little.
constexpr double kNoArea = 1e-7;

double draw(int low, int high, double per_unit) { return *rc::gen::inRange(low, high) / per_unit; }

FreeSpace any_space() {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const GridMap map = test::random_map(random, random.between(3, 9), random.between(3, 9));
  const Polygon outline = test::random_outline();
  const Footprint footprint = *Footprint::polygon(outline.scaled(map.frame().resolution));
  return *make_free_space(map, {.footprint = footprint, .outside = test::random_outside(random)});
}

/// A random pose on the map. Half of them lie on quarters of cells and along the axes, where edges touch
/// squares.
Pose any_pose(const FreeSpace& space) {
  if (*rc::gen::arbitrary<bool>()) {
    return {draw(0, 4 * space.width() + 1, 4), draw(0, 4 * space.height() + 1, 4),
            draw(0, 4, 2) * kPi};
  }
  return {draw(0, 100 * space.width() + 1, 100), draw(0, 100 * space.height() + 1, 100),
          draw(-314, 315, 100)};
}

constexpr int kPoses = 30;  // of each robot on each map

RC_GTEST_PROP(PolygonFits, WhereItHasNoAreaInBlockedSquares, ()) {
  const FreeSpace space = any_space();
  const auto blocked = test::blocked_squares(space);
  for (int i = 0; i < kPoses; ++i) {
    const Pose pose = any_pose(space);
    const double overlap = test::worst_overlap(space, blocked, pose);
    if (overlap > kNoArea) RC_ASSERT(!space.fits(pose));
    if (overlap < 1e-12) RC_ASSERT(space.fits(pose));
  }
}

RC_GTEST_PROP(PolygonFits, AtEveryHeadingInPassableCellsAndAtNoneInImpossibleOnes, ()) {
  const FreeSpace space = any_space();
  const double heading = draw(-314, 315, 100);
  for (const Cell cell : every_cell(space)) {
    if (space.passable()[cell]) RC_ASSERT(space.possible()[cell]);
    if (space.passable()[cell]) RC_ASSERT(space.fits(pose_at(cell, heading)));
    if (!space.possible()[cell]) RC_ASSERT(!space.fits(pose_at(cell, heading)));
  }
}

/// Samples a way; between samples no point of the polygon moves more than `step`. Finds the worst
/// overlap, and whether the polygon comes nearer to a blocked square than the margin.
struct Sampled {
  double overlap = 0;
  bool near = false;
};

template <class Way>
Sampled sampled(const FreeSpace& space, const Way& way, double whole, double moves, double margin) {
  const auto blocked = test::blocked_squares(space);
  constexpr double kStep = 0.02;
  const int samples = static_cast<int>(std::ceil(moves / kStep)) + 1;
  Sampled result;
  for (int i = 0; i <= samples; ++i) {
    const Pose pose = pose_on(way, whole * i / samples);
    result.overlap = std::max(result.overlap, test::worst_overlap(space, blocked, pose));
    if (!result.near) {
      result.near = test::worst_overlap(space, blocked, pose, margin + kStep) > 0;
    }
  }
  return result;
}

template <class Way>
void check_sweep(const FreeSpace& space, const Way& way, double whole, double moves,
                 double tolerance) {
  const bool fits = fits_along(space, way, {.tolerance = tolerance});
  const Sampled seen = sampled(space, way, whole, moves, 2 * tolerance);
  if (seen.overlap > kNoArea) RC_ASSERT(!fits);  // nothing is ever missed
  if (!seen.near) RC_ASSERT(fits);
}

double any_tolerance() { return *rc::gen::element(0.01, 0.05, 0.2); }

RC_GTEST_PROP(PolygonFitsAlong, AnArcWhereItFitsAtEverySample, ()) {
  const FreeSpace space = any_space();
  for (int i = 0; i < 5; ++i) {
    const double length = draw(-400, 401, 100);
    const double turn = draw(-300, 301, 100);
    const Arc arc{any_pose(space), length, length == 0 ? 0 : turn / length};
    const double moves = std::abs(length) + space.radius_in_cells() * std::abs(turn);
    check_sweep(space, arc, length, moves, any_tolerance());
  }
}

RC_GTEST_PROP(PolygonFitsAlong, ATurnInPlaceWhereItFitsAtEverySample, ()) {
  const FreeSpace space = any_space();
  for (int i = 0; i < 5; ++i) {
    const TurnInPlace turn{any_pose(space), draw(-628, 629, 100)};
    const double moves = space.radius_in_cells() * std::abs(turn.angle);
    check_sweep(space, turn, turn.angle, moves, any_tolerance());
  }
}

RC_GTEST_PROP(PolygonFitsAlong, ALineFacingAlongIt, ()) {
  const FreeSpace space = any_space();
  for (int i = 0; i < 5; ++i) {
    const Pose from = any_pose(space);
    const Pose to = any_pose(space);
    const Line line{from.point(), to.point()};
    if (line.length() == 0) continue;
    const Arc arc{{from.x, from.y, std::atan2(to.y - from.y, to.x - from.x)}, line.length(), 0};
    const bool fits = fits_along(space, line);
    const Sampled seen = sampled(space, arc, arc.length, arc.length, 0);
    if (seen.overlap > kNoArea) RC_ASSERT(!fits);
    if (!seen.near) RC_ASSERT(fits);
  }
}

RC_GTEST_PROP(PolygonFitsAlong, EverythingThatItsDiscDoes, ()) {
  const FreeSpace space = any_space();
  for (int i = 0; i < kPoses; ++i) {
    const Pose from = any_pose(space);
    const Line line{from.point(), any_pose(space).point()};
    const double length = draw(-400, 401, 100);
    const Arc arc{from, length, length == 0 ? 0 : draw(-300, 301, 100) / length};
    if (disc_fits_along(space, line)) RC_ASSERT(fits_along(space, line));
    if (disc_fits_along(space, arc)) RC_ASSERT(fits_along(space, arc));
  }
}

/// The base point of a fork may be in the rack behind it, not the fork.
TEST(PolygonFits, WithItsBasePointInAnObstacle) {
  const Footprint fork = *parse_footprint("2.9,0.4; 0.6,0.4; 0.6,-0.4; 2.9,-0.4");
  const FreeSpace space = test::drawn_space("?......\n#......\n.......",
                                            {.footprint = fork, .outside = OutsidePolicy::blocked});
  for (const double y : {0.5, 1.5}) EXPECT_TRUE(space.fits({0.5, y, 0}));
  EXPECT_FALSE(space.passable(Cell{0, 1}));
  EXPECT_TRUE(space.possible()[(Cell{0, 1})]);
  EXPECT_TRUE(fits_along(space, Line{{0.5, 1.5}, {3.5, 1.5}}));
  EXPECT_EQ(space.why_blocked(Pose{0.5, 1.5, kPi / 2}), BlockReason::leaves);
  EXPECT_EQ(space.why_blocked(Pose{3.5, 1.5, kPi}), BlockReason::overlaps);
  EXPECT_EQ(space.why_blocked(Pose{-0.1, 1.5, 0}), BlockReason::outside) << "it stays on the map";
}

const Footprint kLong = *parse_footprint("1.4,0.5;-1.4,0.5;-1.4,-0.5;1.4,-0.5");

TEST(PolygonFitsAlong, ACorridorAsWideAsItself) {
  const FreeSpace space = test::drawn_space("#######\n.......\n#######", {.footprint = kLong});
  EXPECT_TRUE(space.fits({3, 1.5, 0}));
  EXPECT_TRUE(fits_along(space, Line{{1.5, 1.5}, {5.5, 1.5}}));
  EXPECT_TRUE(fits_along(space, Line{{5.5, 1.5}, {1.5, 1.5}}));
  EXPECT_FALSE(disc_fits_along(space, Line{{1.5, 1.5}, {5.5, 1.5}}));
  EXPECT_FALSE(fits_along(space, Line{{1.5, 1.5}, {5.5, 1.501}}));
  EXPECT_FALSE(fits_along(space, TurnInPlace{{3.5, 1.5, 0}, 0.1}));
  EXPECT_EQ(space.why_blocked(Pose{3.5, 1.5, 0.1}), BlockReason::overlaps);
}

/// A robot whose tail reaches far back, beside a wall, cannot turn through it.
TEST(PolygonFitsAlong, HalfATurnTheWayThatFits) {
  const FreeSpace space = test::drawn_space(
      ".......\n.......\n.......\n.......\n#######",
      {.footprint = *Footprint::polygon(
           *Polygon::make({{0.5, 0.4}, {-2.5, 0.4}, {-2.5, -0.4}, {0.5, -0.4}}))});
  const Point joint{3.5, 3.2};
  for (const double rounding : {-1e-15, 0.0, 1e-15}) {
    const double before = 0;
    const TurnInPlace there = turn_between(space, joint, before, kPi + rounding);
    EXPECT_TRUE(fits_along(space, there)) << there.angle;
    EXPECT_TRUE(turns_with_margin(space, joint, before, kPi + rounding));
    EXPECT_NEAR(std::abs(there.angle), kPi, 1e-9);
    const TurnInPlace blocked{there.from, -there.angle};
    EXPECT_FALSE(fits_along(space, blocked));
  }
  EXPECT_NEAR(turn_between(space, joint, 0, 1).angle, 1, 1e-12) << "the shorter way, free or not";
  EXPECT_NEAR(turn_between(space, joint, 0, -1).angle, -1, 1e-12);
}

TEST(PolygonFitsAlong, ItNeverHopsAThinWall) {
  const FreeSpace space = test::drawn_space(".......\n.......\n...#...\n.......\n.......",
                                            {.footprint = kLong, .outside = OutsidePolicy::free});
  const Pose beside{2.5, 2.5, kPi / 2};
  EXPECT_TRUE(space.fits(beside));
  EXPECT_FALSE(fits_along(space, TurnInPlace{beside, kPi}, {.tolerance = 0.2}));
  constexpr double kRadius = 0.3;
  const Arc circle{beside, 2 * kPi * kRadius, 1 / kRadius};
  EXPECT_TRUE(space.fits(end_of(circle)));
  EXPECT_FALSE(fits_along(space, circle, {.tolerance = 0.2}));
}

TEST(PolygonFits, SaysWhyNot) {
  const FreeSpace space = test::drawn_space(
      "?....\n.....\n....#", {.footprint = kLong, .outside = OutsidePolicy::blocked});
  EXPECT_EQ(space.why_blocked(Pose{-1, 1.5, 0}), BlockReason::outside);
  EXPECT_EQ(space.why_blocked(Pose{1, 1.5, 0}), BlockReason::leaves);
  EXPECT_EQ(space.why_blocked(Pose{2.5, 1.5, 0}), std::nullopt);
  EXPECT_EQ(space.why_blocked(Pose{3.5, 2.5, 0}), BlockReason::overlaps);
  EXPECT_EQ(space.why_blocked(Pose{2.5, 1.5, kPi / 2}), std::nullopt);
  EXPECT_EQ(space.why_blocked(Pose{2.5, 0.5, kPi / 2}), BlockReason::leaves);
}

TEST(PointAndDiscFit, AtPosesAsTheirSweepsSay) {
  const FreeSpace point = test::drawn_space("..#\n...");
  EXPECT_TRUE(point.fits({2, 0.5, 1}));  // on the edge of the obstacle
  EXPECT_EQ(point.why_blocked(Pose{2.5, 0.5, 0}), BlockReason::obstacle);
  EXPECT_EQ(point.why_blocked(Pose{3.5, 1.5, 0}), BlockReason::outside);
  const FreeSpace disc = test::drawn_space(
      "..#\n...", {.footprint = Footprint::disc(0.5), .outside = OutsidePolicy::blocked});
  EXPECT_TRUE(disc.fits({1.5, 0.5, 0}));
  EXPECT_EQ(disc.why_blocked(Pose{1.75, 0.75, 0}), BlockReason::too_close);

  const FreeSpace box = *make_free_space(
      point.obstacles(), {.footprint = *parse_footprint("0.4,0.2;-0.4,0.2;0,-0.4")});
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Pose pose : {Pose{kNan, 1.5, 0}, Pose{1.5, kNan, 0}, Pose{1.5, 1.5, kNan},
                          Pose{kInfinity, 1.5, 0}, Pose{1.5, -kInfinity, 0}}) {
    for (const FreeSpace& any : {box, point, disc}) {
      EXPECT_EQ(any.why_blocked(pose), BlockReason::outside) << pose.x << "," << pose.y;
    }
  }
  EXPECT_EQ(disc.why_blocked(Pose{0.4, 1, 0}), BlockReason::over_edge);
}

}  // namespace
}  // namespace wend
