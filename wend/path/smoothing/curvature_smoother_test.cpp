#include "wend/path/smoothing/curvature_smoother.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"

namespace wend {
namespace {

using ::testing::HasSubstr;

/// To the right and then up, in steps of one cell.
Path right_angle(int leg) {
  Path path;
  for (int x = 0; x <= leg; ++x) path.append({x, 1});
  for (int y = 2; y <= leg + 1; ++y) path.append({leg, y});
  return path;
}

double smallest_radius(const Path& path, const FreeSpace& space) {
  return measure(path, space)->rounded_turning_radius;
}

TEST(CurvatureSmoother, WidensBendsToItsRadius) {
  const FreeSpace space = test::open_space(40, 40);
  for (const double radius : {1.0, 2.0, 4.0, 8.0}) {
    const auto smoothed = smooth_by_curvature(right_angle(30), space, {.radius = radius});
    ASSERT_TRUE(smoothed);
    EXPECT_TRUE(smoothed->within_bound) << radius;
    EXPECT_TRUE(smoothed->converged);
    EXPECT_GE(smallest_radius(smoothed->path, space), radius * (1 - 1e-5));
    EXPECT_EQ(smoothed->held, 0);
    EXPECT_EQ(smoothed->path.points().front(), (Point{0.5, 1.5}));
    EXPECT_EQ(smoothed->path.points().back(), (Point{30.5, 31.5}));
  }
}

/// Lines of a pulled path meet sharply, though the circle through three of its points is large.
TEST(CurvatureSmoother, SeesBendsBetweenLongLines) {
  const FreeSpace space = test::open_space(40, 40);
  const Path corner = Path::along({{1, 1}, {35, 1}, {35, 35}});
  EXPECT_LT(smallest_radius(corner, space), 0.25);
  const auto smoothed = smooth_by_curvature(corner, space, {.radius = 4});
  EXPECT_TRUE(smoothed->within_bound);
  const auto points = smoothed->path.points();
  EXPECT_GT(points.size(), 40U);
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_LT(distance(points[i - 1], points[i]), 2);
  EXPECT_GE(smallest_radius(smoothed->path, space), 4 * (1 - 1e-5));
}

RC_GTEST_PROP(CurvatureSmoother, SaysOfItsBendsWhatTheMetricsSay, ()) {
  std::vector<Point> points(static_cast<std::size_t>(*rc::gen::inRange(1, 8)));
  for (Point& point : points)
    point = {*rc::gen::inRange(0, 60) / 4.0, *rc::gen::inRange(0, 60) / 4.0};
  const FreeSpace space = test::open_space(15, 15);
  CurvatureOptions options;
  options.radius = *rc::gen::inRange(0, 40) / 4.0;
  options.max_sweeps = *rc::gen::element(1, 60, 500);
  options.unsafe = *rc::gen::arbitrary<bool>();
  const auto smoothed = smooth_by_curvature(Path::along(points), space, options);
  RC_ASSERT(smoothed.has_value());
  const double smallest = smallest_radius(smoothed->path, space);
  if (smoothed->within_bound) {
    RC_ASSERT(smallest >= options.radius * (1 - 1e-5));
  } else {
    RC_ASSERT(smallest < options.radius);
  }
  for (const Point point : smoothed->path.points()) RC_ASSERT(std::isfinite(point.x + point.y));
}

TEST(CurvatureSmoother, SaysWhereThereIsNoRoom) {
  const FreeSpace corridor = test::drawn_space(
      "#######.\n"
      "........\n"
      ".#######\n"
      "........\n"
      "#######.\n");
  const Path around({{7, 1},
                     {6, 1},
                     {5, 1},
                     {4, 1},
                     {3, 1},
                     {2, 1},
                     {1, 1},
                     {0, 1},
                     {0, 2},
                     {0, 3},
                     {1, 3},
                     {2, 3},
                     {3, 3},
                     {4, 3},
                     {5, 3},
                     {6, 3},
                     {7, 3}});
  const auto smoothed = smooth_by_curvature(around, corridor, {.radius = 3});
  ASSERT_TRUE(smoothed);
  EXPECT_FALSE(smoothed->within_bound);
  EXPECT_FALSE(first_collision(smoothed->path, corridor));
  EXPECT_TRUE(smooth_by_curvature(around, corridor, {.radius = 0})->within_bound);
}

TEST(CurvatureSmoother, RefusesWhatItCannotDo) {
  const FreeSpace space = test::open_space(40, 40);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const CurvatureOptions& options :
       {CurvatureOptions{.radius = -1}, CurvatureOptions{.radius = nan},
        CurvatureOptions{.alpha = -1}, CurvatureOptions{.alpha = 1, .beta = 0.5},
        CurvatureOptions{.max_sweeps = 0}}) {
    const auto refused = smooth_by_curvature(right_angle(5), space, options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Status::invalid_option);
  }
  const Path drive = Path::through({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(smooth_by_curvature(drive, space).error().status, Status::unsupported_query);
  const auto off = smooth_by_curvature(Path({{0, 0}, {50, 0}}), space);
  EXPECT_THAT(off.error().message, HasSubstr("leaves the map"));
}

TEST(CurvatureSmoother, IsInTheRegistry) {
  const SmootherInfo* curvature = smoothers().find("curvature");
  ASSERT_NE(curvature, nullptr);
  const FreeSpace space = test::open_space(40, 40);
  EXPECT_EQ((*curvature->make({{"radius", "2"}}))(right_angle(9), space)->path,
            smooth_by_curvature(right_angle(9), space, {.radius = 2})->path);
}

}  // namespace
}  // namespace wend
