#include "wend/path/polyline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/path/dense_poses.hpp"

namespace wend {
namespace {

Point any_point() { return {*rc::gen::inRange(-80, 80) / 4.0, *rc::gen::inRange(-80, 80) / 4.0}; }

std::vector<Point> any_points() {
  std::vector<Point> points(static_cast<std::size_t>(*rc::gen::inRange(1, 12)));
  for (Point& point : points) point = any_point();
  return points;
}

RC_GTEST_PROP(Polyline, IsAsLongAsItsLinesAndGoesThroughItsPoints, ()) {
  const std::vector<Point> points = any_points();
  const bool closed = *rc::gen::arbitrary<bool>();
  const Polyline line(points, closed);
  double length = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) length += distance(points[i - 1], points[i]);
    RC_ASSERT(distance(line.at(length).point(), points[i]) < 1e-9);
  }
  if (closed) length += distance(points.back(), points.front());
  RC_ASSERT(std::abs(line.length() - length) < 1e-9);
}

RC_GTEST_PROP(Polyline, NearestIsNoFartherThanAnyPlaceBetween, ()) {
  const Polyline line(any_points(), *rc::gen::arbitrary<bool>());
  const Point point = any_point();
  const double from = line.length() * *rc::gen::inRange(0, 100) / 100.0;
  const double to = from + (line.length() - from) * *rc::gen::inRange(0, 100) / 100.0;
  const OnPolyline nearest = line.nearest(point, from, to);
  RC_ASSERT(nearest.along >= from - 1e-9);
  RC_ASSERT(nearest.along <= to + 1e-9);
  RC_ASSERT(distance(line.at(nearest.along).point(), nearest.point) < 1e-6);
  RC_ASSERT(std::abs(distance(point, nearest.point) - nearest.distance) < 1e-9);
  for (int i = 0; i <= 200; ++i) {
    const double along = from + (to - from) * i / 200;
    RC_ASSERT(distance(line.at(along).point(), point) >= nearest.distance - 1e-9);
  }
}

TEST(Polyline, HeadsAlongTheLineThatBegins) {
  const Polyline line(std::vector<Point>{{0, 0}, {3, 0}, {3, 0}, {3, 4}});
  EXPECT_EQ(line.points().size(), 3U);
  EXPECT_EQ(line.at(2), (Pose{2, 0, 0}));
  EXPECT_DOUBLE_EQ(line.at(3).heading, kPi / 2);
  EXPECT_DOUBLE_EQ(line.at(99).y, 4);
}

TEST(PosesAlong, AreEvenlySpacedAndReachTheEnd) {
  const auto poses = poses_along(Polyline({{0, 0}, {3, 0}, {3, 2}}), 2);
  EXPECT_THAT(poses, ::testing::ElementsAre(Pose{0, 0, 0}, Pose{2, 0, 0}, Pose{3, 1, kPi / 2},
                                            Pose{3, 2, kPi / 2}));
  EXPECT_EQ(poses_along(Polyline({{0, 0}, {4, 0}}), 2).size(), 3U) << "the end counts once";
  EXPECT_THAT(poses_along(Polyline({{1, 2}}), 2), ::testing::ElementsAre(Pose{1, 2, 0}));
  const Path aside = Path::through({{0, 0, 0}, {0, 3, 0}, {0, 3, 1}});
  const std::vector<Pose> facing = poses_along(JoinedPoses(aside.driven_poses()), 2);
  ASSERT_EQ(facing.size(), 3U);
  EXPECT_NEAR(distance(facing[1].point(), {0, 2}), 0, 1e-12);
  EXPECT_EQ(facing[1].heading, 0) << "as the path says, not along its way";
  EXPECT_EQ(facing[2], (Pose{0, 3, 1}));
}

TEST(Polyline, OfADriveKeepsToItsArcs) {
  const Path drive = Path::through({{0, 0, 0}, {5, 5, kPi / 2}, {5, 9, kPi / 2}});
  const Polyline line = polyline_of(drive, false, 0.001);
  EXPECT_NEAR(line.length(), 5 * kPi / 2 + 4, 0.01);
  for (int i = 0; i <= 100; ++i) {
    const Point point = line.at(line.length() * i / 100).point();
    const double off = point.y > 5 ? std::abs(point.x - 5) : std::abs(distance(point, {0, 5}) - 5);
    EXPECT_LT(off, 0.0011) << point.x << "," << point.y;
  }
  const Polyline of_arcs = polyline_of(drive.arcs(), 0.001);
  EXPECT_THAT(of_arcs.points(), ::testing::ElementsAreArray(line.points()));
}

TEST(Polyline, OfManyArcsHasNoMoreChordsThanItsLimit) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 40; ++i) poses.push_back({4.0 * (i % 2), i / 4.0, i % 2 == 0 ? 0.0 : 0.8});
  const Path drive = Path::through(poses);
  for (const double tolerance : {0.0, 1e-300}) {
    const Polyline line = polyline_of(drive, false, tolerance);
    EXPECT_LE(line.points().size(), kMostPosesAlong + poses.size()) << tolerance;
    EXPECT_NEAR(line.length(), drive.length(), 1e-6) << tolerance << ": every arc has its share";
    EXPECT_LE(dense_poses(drive, tolerance).size(), kMostPosesAlong + poses.size()) << tolerance;
  }
}

/// Points of a circle, 10 degrees apart.
std::vector<Point> coarse_circle() {
  std::vector<Point> points;
  for (int i = 0; i < 36; ++i) {
    const double angle = i * kPi / 18;
    points.push_back({4 * std::sin(angle), -4 * std::cos(angle)});
  }
  return points;
}

TEST(Polyline, HasTheHeadingOfTheCurveThatItsPointsAreOf) {
  const Polyline circle(coarse_circle(), true);
  double lines_are_off = 0;
  double mean_is_off = 0;
  for (int i = 0; i < 720; ++i) {
    const double along = circle.length() * i / 720;
    const double exact = 2 * kPi * i / 720;
    const auto off = [&](double heading) { return std::abs(normalized_angle(heading - exact)); };
    lines_are_off = std::max(lines_are_off, off(circle.at(along).heading));
    mean_is_off = std::max(mean_is_off, off(circle.heading_at(along, 1)));
  }
  EXPECT_GT(lines_are_off, radians_from(4.9)) << "a saw";
  EXPECT_LT(mean_is_off, radians_from(1));
}

TEST(Polyline, KeepsTheMeanHeadingWithinItsEnds) {
  const Polyline corner({{0, 0}, {4, 0}, {4, 4}});
  EXPECT_EQ(corner.heading_at(0, 1), 0);
  EXPECT_EQ(corner.heading_at(8, 1), kPi / 2);
  EXPECT_NEAR(corner.heading_at(4, 1), kPi / 4, 1e-12);
  EXPECT_EQ(corner.heading_at(2, 1), 0) << "a window that ends before the corner";
  EXPECT_EQ(corner.heading_at(3.5, 0), 0) << "no window";
}

TEST(Polyline, HasTheHeadingOfALineWhereItTurnsBack) {
  const Polyline there_and_back({{0, 0}, {4, 0}, {0, 0}});
  EXPECT_NEAR(std::abs(there_and_back.heading_at(4, 1)), kPi, 1e-12);
  EXPECT_EQ(there_and_back.heading_at(2, 1), 0);
  EXPECT_EQ(Polyline({{3, 3}}).heading_at(0, 1), 0);
}

}  // namespace
}  // namespace wend
