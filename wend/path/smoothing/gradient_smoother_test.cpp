#include "wend/path/smoothing/gradient_smoother.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_path.hpp"
#include "tests/testing/sampled_robot.hpp"
#include "tests/testing/smoothing_objective.hpp"
#include "wend/geometry/line.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/robot/sweep/point_sweep.hpp"

namespace wend {
namespace {

using ::testing::HasSubstr;

const Path kStairs = Path({{1, 1}, {2, 1}, {2, 2}, {3, 2}, {3, 3}, {4, 3}, {4, 4}, {5, 4}});

Path random_waypoints() {
  std::vector<Point> points(static_cast<std::size_t>(*rc::gen::inRange(1, 12)));
  for (Point& point : points) {
    point = {*rc::gen::inRange(0, 80) / 4.0, *rc::gen::inRange(0, 80) / 4.0};
  }
  return Path::along(points);
}

/// Weights that converge.
GradientOptions any_options() {
  GradientOptions options;
  options.in_place = *rc::gen::arbitrary<bool>();
  options.alpha = *rc::gen::inRange(0, 100) / 100.0;
  options.beta = *rc::gen::inRange(0, 100) / 100.0 * (options.in_place ? 0.5 : 0.25);
  return options;
}

RC_GTEST_PROP(GradientSmoother, DoesTheReferenceSweep, ()) {
  const Path path = random_waypoints();
  GradientOptions options = any_options();
  options.max_sweeps = 1;
  options.unsafe = true;
  const auto p = path.points();
  auto s = p;
  const auto old = p;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const auto& left = options.in_place ? s : old;
    const double a = options.alpha;
    const double b = options.beta;
    s[i].x += -(a + 2 * b) * old[i].x + a * p[i].x + b * left[i - 1].x + b * old[i + 1].x;
    s[i].y += -(a + 2 * b) * old[i].y + a * p[i].y + b * left[i - 1].y + b * old[i + 1].y;
  }
  const auto smoothed = smooth_by_gradient(path, test::open_space(20, 20), options)->path.points();
  RC_ASSERT(smoothed.size() == s.size());
  for (std::size_t i = 0; i < s.size(); ++i) RC_ASSERT(distance(smoothed[i], s[i]) < 1e-12);
}

RC_GTEST_PROP(GradientSmoother, LetsTheObjectiveOnlyFallFromSweepToSweep, ()) {
  const Path path = random_waypoints();
  GradientOptions options = any_options();
  options.unsafe = true;
  options.epsilon = 0;
  double last = smoothing_objective(path, path, options);
  for (options.max_sweeps = 1; options.max_sweeps <= 8; ++options.max_sweeps) {
    const auto smoothed = smooth_by_gradient(path, test::open_space(20, 20), options);
    const double objective = smoothing_objective(path, smoothed->path, options);
    RC_ASSERT(objective <= last * (1 + 1e-12));
    last = objective;
  }
}

/// The objective falls with each sweep, but the length need not: sweeps that are not in place overshoot.
RC_GTEST_PROP(GradientSmoother, InTheOpenDoesTheSameSafelyUnlessThePathGetsLonger, ()) {
  std::vector<Point> points = random_waypoints().points();
  for (Point& point : points) point = {point.x + 20, point.y + 20};  // far from the map's edge
  const Path path = Path::along(points);
  const auto space = test::open_space(60, 60);
  GradientOptions options = any_options();
  options.max_sweeps = *rc::gen::inRange(1, 9);
  const auto safe = smooth_by_gradient(path, space, options);
  options.unsafe = true;
  const auto unsafe = smooth_by_gradient(path, space, options);
  const bool longer = unsafe->path.length() > path.length() * (1 + 1e-12);
  RC_ASSERT(safe->held == 0);
  RC_ASSERT(safe->returned == longer);
  RC_ASSERT(safe->path.points() == (longer ? path : unsafe->path).points());
}

TEST(GradientSmoother, GivesBackThePathWhereASweepOvershootsAndMakesItLonger) {
  std::vector<Point> points(9, Point{0, 0});
  points.back() = {0, 0.25};
  const Path path = Path::along(points);
  const GradientOptions options{.alpha = 0.64, .beta = 0.245, .epsilon = 0, .max_sweeps = 7};
  const auto smoothed = smooth_by_gradient(path, test::open_space(20, 20), options);
  EXPECT_TRUE(smoothed->returned);
  EXPECT_EQ(smoothed->path.points(), points);
}

RC_GTEST_PROP(GradientSmoother, WithoutBetaGivesBackThePath, ()) {
  const Path path = random_waypoints();
  GradientOptions options = any_options();
  options.beta = 0;
  const auto smoothed = smooth_by_gradient(path, test::open_space(20, 20), options);
  RC_ASSERT(smoothed->path.points() == path.points());
  RC_ASSERT(smoothed->converged);
}

RC_GTEST_PROP(GradientSmoother, WithoutAlphaTendsToTheStraightLine, ()) {
  const Path path = random_waypoints();
  GradientOptions options{.alpha = 0, .beta = 0.2, .epsilon = 1e-22, .max_sweeps = 100000};
  options.in_place = *rc::gen::arbitrary<bool>();
  const auto smoothed = smooth_by_gradient(path, test::open_space(20, 20), options);
  RC_ASSERT(smoothed->converged);
  const auto points = smoothed->path.points();
  const Line line{points.front(), points.back()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(points.size() - 1);
    RC_ASSERT(distance(points[i], line.at(share)) < 1e-8);
  }
}

TEST(GradientSmoother, ConvergesToWhereTheGradientIsZero) {
  for (const bool in_place : {false, true}) {
    const GradientOptions options{.epsilon = 1e-24, .in_place = in_place};
    const auto smoothed = smooth_by_gradient(kStairs, test::open_space(7, 7), options);
    ASSERT_TRUE(smoothed->converged);
    const auto s = smoothed->path.points();
    const auto p = kStairs.points();
    for (std::size_t i = 1; i + 1 < s.size(); ++i) {
      EXPECT_NEAR(0.1 * (p[i].x - s[i].x) + 0.3 * (s[i - 1].x + s[i + 1].x - 2 * s[i].x), 0, 1e-11);
      EXPECT_NEAR(0.1 * (p[i].y - s[i].y) + 0.3 * (s[i - 1].y + s[i + 1].y - 2 * s[i].y), 0, 1e-11);
    }
  }
}

TEST(GradientSmoother, EndsByEpsilonOrAfterItsSweeps) {
  const FreeSpace space = test::open_space(7, 7);
  const auto all = smooth_by_gradient(kStairs, space, {});
  EXPECT_TRUE(all->converged);
  EXPECT_GT(all->sweeps, 3U);
  const auto three = smooth_by_gradient(kStairs, space, {.max_sweeps = 3});
  EXPECT_FALSE(three->converged);
  EXPECT_EQ(three->sweeps, 3U);
  EXPECT_LT(smooth_by_gradient(kStairs, space, {.epsilon = 0.1})->sweeps, all->sweeps);
}

TEST(GradientSmoother, LeavesShortPathsAlone) {
  for (const Path& path : {Path({{1, 1}}), Path({{1, 1}, {2, 2}})}) {
    for (const bool unsafe : {false, true}) {
      const auto smoothed = smooth_by_gradient(path, test::open_space(3, 3), {.unsafe = unsafe});
      ASSERT_TRUE(smoothed);
      EXPECT_EQ(smoothed->path, Path::along(path.points()));
      EXPECT_TRUE(smoothed->converged);
      EXPECT_EQ(smoothed->held, 0);
    }
  }
}

TEST(GradientSmoother, HoldsBackWhereItWouldCollide) {
  // Around the end of a wall: the reference cuts through it.
  const FreeSpace space = test::drawn_space(".....\n.....\n..#..\n..#..\n..#..");
  const Path path({{1, 4}, {1, 3}, {1, 2}, {1, 1}, {2, 1}, {3, 1}, {3, 2}, {3, 3}, {3, 4}});
  const GradientOptions keen{.alpha = 0.01, .beta = 0.4};
  const auto safe = smooth_by_gradient(path, space, keen);
  EXPECT_FALSE(first_collision(safe->path, space));
  EXPECT_GT(safe->held, 0);
  GradientOptions unsafe = keen;
  unsafe.unsafe = true;
  const auto reference = smooth_by_gradient(path, space, unsafe);
  EXPECT_TRUE(first_collision(reference->path, space));
  EXPECT_EQ(reference->held, 0);
}

TEST(GradientSmoother, IsSafeOnPathsThatTouchObstaclesAndGaps) {
  int in_gaps = 0;
  for (std::uint64_t seed = 1; seed <= 3000 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(2, 10), random.between(2, 10));
    const double radius = test::one_of<double>(random, std::array{0.0, 0.0, 0.0, 0.5, 1.0});
    const FreeSpace space =
        *make_free_space(map, {.footprint = Footprint::disc(radius * map.frame().resolution)});
    const Path path = test::random_free_path(random, space, Adjacency::edges);
    if (path.empty()) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map) +
                 test::text_of(path));
    for (const Point point : path.points()) in_gaps += in_gap(space, point) ? 1 : 0;
    const auto smoothed =
        smooth_by_gradient(path, space, {.alpha = 0.02, .beta = 0.4, .epsilon = 1e-6});
    ASSERT_TRUE(smoothed);
    ASSERT_FALSE(first_collision(smoothed->path, space)) << test::text_of(smoothed->path);
    ASSERT_LE(smoothed->path.length(), path.length() + 1e-9);
    const test::SampledRobot robot(map, radius, space.outside() == OutsidePolicy::blocked);
    for (const Arc& arc : smoothed->path.arcs()) {
      const int steps = 1 + static_cast<int>(arc.length / 0.02);
      for (int i = 0; i <= steps; ++i) {
        ASSERT_FALSE(robot.collides_at(point_on(arc, arc.length * i / steps)));
      }
    }
  }
  EXPECT_GT(in_gaps, 30);
}

Error error_of(const Path& path, const FreeSpace& space, const GradientOptions& options) {
  const auto smoothed = smooth_by_gradient(path, space, options);
  if (smoothed) return {Status::found, ""};
  return smoothed.error();
}

TEST(GradientSmoother, RefusesWeightsThatDiverge) {
  const FreeSpace space = test::open_space(7, 7);
  const Error error = error_of(kStairs, space, {.alpha = 0.4, .beta = 0.4});
  EXPECT_EQ(error.status, Status::invalid_option);
  EXPECT_THAT(error.message, HasSubstr("alpha + 4 beta is 2"));
  EXPECT_THAT(error.message, HasSubstr("beta must be less than 0.4, or set in_place"));
  EXPECT_EQ(error_of(kStairs, space, {.alpha = 0.4, .beta = 0.4, .in_place = true}).status,
            Status::found);
  EXPECT_THAT(error_of(kStairs, space, {.alpha = 1, .beta = 0.5, .in_place = true}).message,
              HasSubstr("alpha + 2 beta is 2"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const GradientOptions& options :
       {GradientOptions{.alpha = -0.1}, GradientOptions{.beta = -0.1},
        GradientOptions{.alpha = nan}, GradientOptions{.beta = nan},
        GradientOptions{.epsilon = nan}, GradientOptions{.max_sweeps = 0},
        GradientOptions{.alpha = 2, .beta = 0}}) {
    EXPECT_EQ(error_of(kStairs, space, options).status, Status::invalid_option);
  }
}

TEST(GradientSmoother, RefusesDrivesAndPathsThatAreNotFree) {
  const FreeSpace space = test::drawn_space("..#\n...");
  const Path drive = Path::through({{0, 0, 0}, {1, 0, 0}});
  for (const bool unsafe : {false, true}) {
    EXPECT_EQ(error_of(drive, space, {.unsafe = unsafe}).status, Status::unsupported_query);
  }
  const Path into({{0, 0}, {1, 0}, {2, 0}});
  const Error error = error_of(into, space, {});
  EXPECT_EQ(error.status, Status::unsupported_query);
  EXPECT_THAT(error.message, HasSubstr("1.5 cells along it, at (2, 0.5), it enters an obstacle"));
  EXPECT_EQ(error_of(into, space, {.unsafe = true}).status, Status::found);
}

TEST(GradientSmoother, IsInTheRegistry) {
  const SmootherInfo* gradient = smoothers().find("gradient");
  ASSERT_NE(gradient, nullptr);
  const FreeSpace space = test::open_space(7, 7);
  EXPECT_EQ((*gradient->make({{"beta", "0.4"}}))(kStairs, space)->path,
            smooth_by_gradient(kStairs, space, {.beta = 0.4})->path);
  const auto wrong = gradient->make({{"beta", "-1"}});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().status, Status::invalid_option);
}

}  // namespace
}  // namespace wend
