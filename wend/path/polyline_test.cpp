#include "wend/path/polyline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "wend/geometry/angle.hpp"

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

TEST(Polyline, OfADriveKeepsToItsArcs) {
  const Path drive = Path::through({{0, 0, 0}, {5, 5, kPi / 2}, {5, 9, kPi / 2}});
  const Polyline line = Polyline::of(drive, false, 0.001);
  EXPECT_NEAR(line.length(), 5 * kPi / 2 + 4, 0.01);
  for (int i = 0; i <= 100; ++i) {
    const Point point = line.at(line.length() * i / 100).point();
    const double off = point.y > 5 ? std::abs(point.x - 5) : std::abs(distance(point, {0, 5}) - 5);
    EXPECT_LT(off, 0.0011) << point.x << "," << point.y;
  }
}

}  // namespace
}  // namespace wend
