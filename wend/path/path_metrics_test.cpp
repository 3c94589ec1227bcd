#include "wend/path/path_metrics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/blocked_squares.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_path.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/direction.hpp"

namespace wend {
namespace {

PathMetrics on_open_ground(const std::vector<Cell>& cells) {
  return *measure(Path(cells), test::open_space(20, 20));
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

TEST(PathMetrics, AreListedOnceEach) {
  const std::vector<Metric> list =
      metrics_of(*measure(Path({{3, 3}, {4, 3}, {4, 4}}), test::open_space(20, 20)));
  std::set<std::string_view> names;
  for (const Metric& metric : list) {
    names.insert(metric.name);
    EXPECT_FALSE(metric.help.empty()) << metric.name;
    EXPECT_FALSE(metric.help.ends_with('.')) << metric.name;
    EXPECT_EQ(metric.in_metres(0.5), metric.value * (metric.unit == MetricUnit::cells ? 0.5 : 1));
  }
  EXPECT_EQ(names.size(), list.size()) << "two have the same name";
  EXPECT_EQ(sizeof(PathMetrics), list.size() * sizeof(double)) << "a member is not in the list";
}

TEST(PathMetrics, TurningBackIsHalfATurn) {
  EXPECT_DOUBLE_EQ(turning({{3, 3}, {4, 3}, {3, 3}}), kPi);
  EXPECT_DOUBLE_EQ(turning({{3, 3}, {3, 4}, {3, 3}, {3, 4}}), 2 * kPi);
  EXPECT_DOUBLE_EQ(turning({{4, 4}, {3, 3}, {4, 4}}), kPi);
}

TEST(PathMetrics, TurningOnceAroundIsAFullTurn) {
  std::vector<Cell> cells{{10, 10}};
  for (int i = 0; i <= kDirections; ++i) {
    cells.push_back(step(cells.back(), static_cast<Direction>(i % kDirections)));
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
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}, {2, 0}, {3, 0}}), space)->mean_clearance, 1.5);
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}, {2, 0}, {2, 1}}), space)->mean_clearance, 1.25);
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}, {2, 1}, {2, 2}}), space)->mean_clearance,
                   (std::sqrt(2) * 1 + 1.5) / (std::sqrt(2) + 1));
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}}), space)->mean_clearance, 0.5);
  EXPECT_DOUBLE_EQ(measure(Path({{3, 0}, {3, 0}}), space)->mean_clearance, 2.5);
}

TEST(PathMetrics, WeighsClearanceAlongLongLinesToo) {
  // Near an obstacle at both ends, far from any between them.
  const FreeSpace space = test::drawn_space("#.................#");
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}, {17, 0}}), space)->mean_clearance,
                   measure(Path::along({{1.5, 0.5}, {17.5, 0.5}}), space)->mean_clearance);
  Path steps;
  for (int x = 1; x <= 17; ++x) steps.append({x, 0});
  EXPECT_DOUBLE_EQ(measure(Path({{1, 0}, {17, 0}}), space)->mean_clearance,
                   measure(steps, space)->mean_clearance);
  EXPECT_GT(measure(steps, space)->mean_clearance, 4);
}

TEST(PathMetrics, HasNoClearanceWhereItCutsACorner) {
  const FreeSpace space = test::drawn_space("...\n.#.\n...");
  EXPECT_EQ(measure(Path({{0, 0}, {1, 0}, {2, 1}}), space)->smallest_clearance, 0);
  EXPECT_EQ(measure(Path({{0, 0}, {1, 0}, {2, 0}, {2, 1}}), space)->smallest_clearance, 0.5);
}

/// Densely sampled: never less than what is claimed, and down to it.
TEST(PathMetrics, SmallestClearanceIsThatOfTheNearestPoint) {
  constexpr int kSamples = 24;  // of a step; the middle is among them
  for (std::uint64_t seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 12), random.between(1, 12));
    const FreeSpace space =
        *make_free_space(map, test::random_robot(random, map.frame().resolution));
    const Path path = test::random_cell_path(random, map.width(), map.height());
    const auto cells = path.cells();
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    double least = test::clearance_at(space, centre_of(cells[0]));
    double longest = 0;
    for (std::size_t i = 1; i < cells.size(); ++i) {
      const double dx = cells[i].x - cells[i - 1].x;
      const double dy = cells[i].y - cells[i - 1].y;
      longest = std::max(longest, std::hypot(dx, dy));
      for (int k = 0; k <= kSamples; ++k) {
        const double share = k / static_cast<double>(kSamples);
        least = std::min(least, test::clearance_at(space, {cells[i - 1].x + 0.5 + share * dx,
                                                           cells[i - 1].y + 0.5 + share * dy}));
      }
    }
    const double smallest = measure(path, space)->smallest_clearance;
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

PathMetrics driven_on_open_ground(const std::vector<Pose>& poses) {
  return *measure(Path::through(poses), test::open_space(20, 20));
}

TEST(PathMetrics, OfADrivenPathAddUpItsArcs) {
  // A quarter circle, a line, and a quarter circle to the other side.
  const PathMetrics metrics =
      driven_on_open_ground({{1, 1, 0}, {2, 2, kPi / 2}, {2, 5, kPi / 2}, {3, 6, 0}});
  EXPECT_DOUBLE_EQ(metrics.length, kPi + 3);
  EXPECT_DOUBLE_EQ(metrics.turning, kPi) << "left and right add up";
  EXPECT_EQ(metrics.reversals, 0);
  EXPECT_EQ(metrics.smallest_clearance, test::kInfinite);
  EXPECT_EQ(metrics.mean_clearance, test::kInfinite);
}

TEST(PathMetrics, CountHowOftenACarChangesGear) {
  const auto reversals = [](const std::vector<Pose>& poses) {
    return driven_on_open_ground(poses).reversals;
  };
  EXPECT_EQ(reversals({{5, 5, 0}, {4, 5, 0}, {3, 5, 0}}), 0) << "in reverse all the way";
  EXPECT_EQ(reversals({{5, 5, 0}, {6, 5, 0}, {5, 5, 0}}), 1);
  EXPECT_EQ(reversals({{5, 5, 0}, {6, 5, 0}, {6, 5, 0}, {5, 5, 0}}), 1) << "a stop between";
  EXPECT_EQ(reversals({{5, 5, 0}, {6, 6, kPi / 2}, {7, 5, kPi}, {6, 5, kPi}}), 2);
  EXPECT_DOUBLE_EQ(driven_on_open_ground({{5, 5, 0}, {6, 5, 0}, {5, 5, 0}}).turning, 0);
  EXPECT_EQ(on_open_ground({{3, 3}, {4, 3}, {3, 3}}).reversals, 0) << "cells have no gear";
}

TEST(PathMetrics, OfACarThatStandsAreThoseOfItsPoint) {
  const FreeSpace space = test::drawn_space("#...\n....");
  for (const auto& poses : {std::vector<Pose>{{4, 2, 0}}, {{4, 2, 0}, {4, 2, 0}}}) {
    const PathMetrics metrics = *measure(Path::through(poses), space);
    EXPECT_EQ(metrics.length, 0);
    EXPECT_EQ(metrics.turning, 0);
    EXPECT_DOUBLE_EQ(metrics.smallest_clearance, std::sqrt(10)) << "on the map's last corner";
    EXPECT_DOUBLE_EQ(metrics.mean_clearance, std::sqrt(10));
  }
}

TEST(PathMetrics, OfADrivenPathKnowTheClearanceOfArcs) {
  const FreeSpace space = test::drawn_space("...\n...\n.#.");
  // Around (0,0), past the corner (1,2), between points of clearance 1.
  const PathMetrics turn = *measure(Path::through({{0, 1, 0}, {1, 0, -kPi / 2}}), space);
  EXPECT_DOUBLE_EQ(turn.smallest_clearance, std::sqrt(5) - 1);
  const PathMetrics line = *measure(Path::through({{1, 1, -kPi / 2}, {1, -1, -kPi / 2}}), space);
  EXPECT_DOUBLE_EQ(line.smallest_clearance, 1);
  EXPECT_DOUBLE_EQ(line.mean_clearance, 2);
  const PathMetrics crossing = *measure(Path::through({{1, 1, kPi / 2}, {1, 4, kPi / 2}}), space);
  EXPECT_EQ(crossing.smallest_clearance, 0);
  EXPECT_DOUBLE_EQ(crossing.mean_clearance, (0.5 + 0 + 0.5) / 3) << "1, 0, 0, 1 at its points";
}

/// What 40 points of each piece say: never less than what is claimed, and down to it.
TEST(PathMetrics, OfArcsAndLinesAreThoseOfTheirPoints) {
  constexpr int kSamples = 40;
  for (std::uint64_t seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 9), random.between(1, 9));
    const FreeSpace space =
        *make_free_space(map, test::random_robot(random, map.frame().resolution));
    const Path path = seed % 2 == 0 ? test::random_drive(random, map.width(), map.height())
                                    : test::random_waypoint_path(random, map.width(), map.height());
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    const Point start = path.points().front();
    double least = test::clearance_at(space, start);
    double longest = 0;
    double length = 0;
    double sum = 0;  // of clearance over length, by the midpoint rule
    for (const Arc& arc : path.arcs()) {
      const double step = std::abs(arc.length) / kSamples;
      for (int i = 0; i <= 2 * kSamples; ++i) {
        const Pose pose = pose_on(arc, arc.length * i / (2 * kSamples));
        const double clearance = test::clearance_at(space, pose.point());
        least = std::min(least, clearance);
        if (i % 2 == 1 && step > 0) sum += step * clearance;
      }
      longest = std::max(longest, step);
      length += std::abs(arc.length);
    }
    const PathMetrics metrics = *measure(path, space);
    ASSERT_NEAR(metrics.length, length, 1e-9);
    if (least == test::kInfinite) {
      ASSERT_EQ(metrics.smallest_clearance, least);
      continue;
    }
    ASSERT_LE(metrics.smallest_clearance, least + 1e-9);
    ASSERT_GE(metrics.smallest_clearance, least - longest / 4 - 1e-9);
    if (length == 0) continue;
    // On a piece of one cell the trapezoid is off by no more than a quarter of a cell.
    ASSERT_NEAR(metrics.mean_clearance, sum / length, 0.25 + longest / 4);
  }
}

TEST(PathMetrics, OfALineThatStandsInPointsIsStraight) {
  const PathMetrics metrics =
      *measure(Path::along({{1, 1}, {4, 5}, {4, 5}, {7, 9}}), test::open_space(40, 40));
  EXPECT_DOUBLE_EQ(metrics.length, 10);
  EXPECT_EQ(metrics.turning, 0);
  EXPECT_TRUE(std::isinf(metrics.smallest_turning_radius));
  EXPECT_TRUE(std::isinf(metrics.rounded_turning_radius));
  EXPECT_EQ(metrics.reversals, 0);
}

/// Of points along the path, by the formula of the distance to a line between two points.
TEST(PathMetrics, DeviationIsThatOfTheFarthestPoint) {
  constexpr int kSamples = 200;
  for (std::uint64_t seed = 1; seed <= 300 && !HasFailure(); ++seed) {
    Random random(seed);
    const Path path = test::random_path(random, 12, 9);
    SCOPED_TRACE(seed);
    const Point a = path.points().front();
    const Point b = path.points().back();
    const double squared = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    double sampled = 0;
    double step = 0;
    for (const Arc& arc : path.arcs()) {
      step = std::max(step, std::abs(arc.length) / kSamples);
      for (int i = 0; i <= kSamples; ++i) {
        const Point p = point_on(arc, arc.length * i / kSamples);
        const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y));
        const double share = squared == 0 ? 0 : std::clamp(along / squared, 0.0, 1.0);
        sampled = std::max(
            sampled, std::hypot(p.x - a.x - share * (b.x - a.x), p.y - a.y - share * (b.y - a.y)));
      }
    }
    const double deviation = measure(path, test::open_space(12, 9))->deviation;
    ASSERT_GE(deviation, sampled - 1e-9);
    ASSERT_LE(deviation, sampled + step / 2 + 1e-9);
  }
}

TEST(PathMetrics, DeviationOfKnownPaths) {
  EXPECT_EQ(on_open_ground({{3, 3}}).deviation, 0);
  EXPECT_EQ(on_open_ground({{3, 3}, {9, 3}}).deviation, 0);
  EXPECT_NEAR(on_open_ground({{3, 3}, {4, 4}, {9, 9}}).deviation, 0, 1e-12);
  EXPECT_EQ(on_open_ground({{3, 3}, {5, 3}, {5, 6}, {3, 6}, {3, 3}}).deviation, std::sqrt(13));
  EXPECT_EQ(on_open_ground({{3, 3}, {9, 3}, {6, 3}}).deviation, 3) << "beyond its end";
  // A half circle to the left and one to the right.
  EXPECT_NEAR(driven_on_open_ground({{1, 5, -kPi / 2}, {3, 3, 0}, {5, 5, kPi / 2}}).deviation, 2,
              1e-12);
  EXPECT_NEAR(driven_on_open_ground({{1, 5, kPi / 2}, {3, 7, 0}, {5, 5, -kPi / 2}}).deviation, 2,
              1e-12);
}

RC_GTEST_PROP(PathMetrics, OfPointsOnACircleNeverOverstateItsRadius, ()) {
  const double radius = *rc::gen::inRange(1, 60) / 4.0;
  const int count = *rc::gen::inRange(3, 200);
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = 2 * kPi * i / count;
    points.push_back({20 + radius * std::cos(angle), 20 + radius * std::sin(angle)});
  }
  const PathMetrics metrics = *measure(Path::along(points), test::open_space(40, 40));
  RC_ASSERT(metrics.smallest_turning_radius == 0);
  RC_ASSERT(metrics.rounded_turning_radius <= radius);
  if (radius * (1 - std::cos(kPi / count)) <= kCornerRounding) {
    RC_ASSERT(metrics.rounded_turning_radius >= radius * std::cos(kPi / count) * (1 - 1e-9));
  }
  RC_ASSERT(std::abs(metrics.turning - 2 * kPi * (count - 1) / count) < 1e-9);
  RC_ASSERT(std::abs(metrics.length - 2 * radius * count * std::sin(kPi / count)) < 1e-9);
}

TEST(PathMetrics, OfASquareTurnByThreeRightAngles) {
  const PathMetrics metrics =
      *measure(Path::along({{5, 5}, {9, 5}, {9, 9}, {5, 9}, {5, 5}}), test::open_space(40, 40));
  EXPECT_DOUBLE_EQ(metrics.length, 16);
  EXPECT_DOUBLE_EQ(metrics.turning, 3 * kPi / 2);
  EXPECT_EQ(metrics.smallest_turning_radius, 0);
  EXPECT_DOUBLE_EQ(metrics.rounded_turning_radius, 0.1 / (std::numbers::sqrt2 - 1));
}

TEST(PathMetrics, OfAPathThatTurnsBackHaveNoTurningRadius) {
  const PathMetrics metrics =
      *measure(Path::along({{5, 5}, {9, 5}, {6, 5}}), test::open_space(40, 40));
  EXPECT_DOUBLE_EQ(metrics.turning, kPi);
  EXPECT_EQ(metrics.smallest_turning_radius, 0);
  EXPECT_EQ(metrics.rounded_turning_radius, 0);
}

/// Leaving out points makes corners sharper, not wider.
TEST(PathMetrics, OfFewPointsAreNoWiderThanOfMany) {
  const FreeSpace space = test::open_space(40, 40);
  const Path dense = Path::along({{1, 5}, {2, 5}, {3, 5}, {4, 6}, {5, 7}, {6, 8}});
  const Path sparse = Path::along({{1, 5}, {3, 5}, {6, 8}});
  EXPECT_NEAR(measure(dense, space)->rounded_turning_radius,
              measure(sparse, space)->rounded_turning_radius, 0.01);
  const Path kink = Path::along({{5, 5}, {35, 5}, {38, 33}});
  EXPECT_LT(measure(kink, space)->rounded_turning_radius, 0.3) << "of 84 degrees, in 30 cells";
  EXPECT_GT(measure(kink, space, 1)->rounded_turning_radius, 2) << "where more is cut off";
  EXPECT_EQ(measure(kink, space, 0)->rounded_turning_radius, 0);
}

TEST(PathMetrics, OfADriveAreThoseOfItsArcs) {
  const Path drive = Path::through({{5, 5, 0}, {8, 8, kPi / 2}, {8, 6, kPi / 2}, {8, 12, kPi / 2}});
  const PathMetrics metrics = *measure(drive, test::open_space(40, 40));
  EXPECT_DOUBLE_EQ(metrics.length, 3 * kPi / 2 + 2 + 6);
  EXPECT_DOUBLE_EQ(metrics.turning, kPi / 2);
  EXPECT_DOUBLE_EQ(metrics.smallest_turning_radius, 3);
  EXPECT_DOUBLE_EQ(metrics.rounded_turning_radius, 3);
  EXPECT_EQ(metrics.reversals, 2);
}

Corner turning_by(double angle, double before = 100, double after = 100) {
  return Corner({-before, 0}, {0, 0}, {after * std::cos(angle), after * std::sin(angle)});
}

TEST(Corner, HasNoRadiusWithoutAWindow) {
  for (const double degrees : {1e-3, 10.0, 84.0, 90.0, 170.0}) {
    EXPECT_EQ(turning_by(radians_from(degrees)).radius(0), 0) << degrees;
  }
  EXPECT_TRUE(std::isinf(turning_by(0).radius(0))) << "there is no corner";
}

TEST(Corner, ThatTurnsBackHasNoRadiusWithAnyWindow) {
  EXPECT_EQ(Corner({0, 0}, {4, 0}, {1, 0}).radius(10), 0);
}

/// The kink that the circle through its three points told to be 3.8 m wide.
TEST(Corner, OfAKinkIsAsTightAsItsWindow) {
  const double radius = turning_by(radians_from(84)).radius(0.05);
  EXPECT_NEAR(radius, 0.05 / (1 / std::cos(radians_from(42)) - 1), 1e-12);
  EXPECT_LT(radius, 0.15);
}

TEST(Corner, IsRoundedNoFartherThanTheMiddleOfItsLines) {
  EXPECT_NEAR(turning_by(kPi / 2, 3, 1).radius(1000), 0.5, 1e-12);
}

/// The arc's middle lies on the bisector, radius / cos(turn / 2) - radius from the corner; it begins
/// radius tan(turn / 2) before it.
RC_GTEST_PROP(Corner, ArcKeepsWithinTheWindowAndTheLines, ()) {
  const double turn = *rc::gen::inRange(1, 1799) / 1800.0 * kPi;
  const double before = *rc::gen::inRange(1, 100) / 7.0;
  const double after = *rc::gen::inRange(1, 100) / 7.0;
  const double window = *rc::gen::inRange(1, 100) / 31.0;
  const double radius = turning_by(turn, before, after).radius(window);
  const double off = radius / std::cos(turn / 2) - radius;
  const double begins = radius * std::tan(turn / 2);
  const double middle = std::min(before, after) / 2;
  RC_ASSERT(off <= window * (1 + 1e-9) && begins <= middle * (1 + 1e-9));
  RC_ASSERT(off >= window * (1 - 1e-6) || begins >= middle * (1 - 1e-6));
}

RC_GTEST_PROP(Corner, WidestTurnIsWhereTheRadiusIsMet, ()) {
  const double turn = *rc::gen::inRange(1, 1799) / 1800.0 * kPi;
  const Corner corner = turning_by(turn, 3, 2);
  const double window = *rc::gen::inRange(1, 100) / 31.0;
  const double radius = corner.radius(window);
  RC_ASSERT(corner.half_turn_tangent() <= corner.widest_half_turn(radius * (1 - 1e-6), window));
  RC_ASSERT(corner.half_turn_tangent() >= corner.widest_half_turn(radius * (1 + 1e-6), window));
}

TEST(Corner, OfTheSnippetIsARightAngle) {
  EXPECT_NEAR(Corner({0, 0}, {1, 0}, {1, 1}).radius(0.1), 0.1 / (std::numbers::sqrt2 - 1), 1e-12);
}

}  // namespace
}  // namespace wend
