#include "wend/robot/sweep/placed_polygon.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/testing/random_polygon.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

Polygon any_polygon() { return test::random_outline(); }

Pose any_pose() {
  if (*rc::gen::arbitrary<bool>()) {
    return {*rc::gen::inRange(-12, 13) / 4.0, *rc::gen::inRange(-12, 13) / 4.0,
            *rc::gen::inRange(0, 4) * kPi / 2};
  }
  return {*rc::gen::inRange(-300, 300) / 100.0, *rc::gen::inRange(-300, 300) / 100.0,
          *rc::gen::inRange(-314, 315) / 100.0};
}

Point in_robot(Point point, const Pose& pose) {
  const double dx = point.x - pose.x;
  const double dy = point.y - pose.y;
  return {std::cos(pose.heading) * dx + std::sin(pose.heading) * dy,
          std::cos(pose.heading) * dy - std::sin(pose.heading) * dx};
}

/// Does any point of a lattice inside the square lie in the polygon, deeper than `depth`?
bool sampled_overlap(const Polygon& polygon, const Pose& pose, Cell square, double depth) {
  constexpr int kSamples = 16;
  for (int i = 0; i < kSamples; ++i) {
    for (int j = 0; j < kSamples; ++j) {
      const Point at =
          in_robot({square.x + (i + 0.5) / kSamples, square.y + (j + 0.5) / kSamples}, pose);
      if (polygon.contains(at) && distance_to_outline(polygon, at) > depth) return true;
    }
  }
  return false;
}

constexpr double kDeepEnough = 1e-6;

RC_GTEST_PROP(PlacedPolygon, OverlapsASquareThatHasAPointOfIt, ()) {
  const Polygon polygon = any_polygon();
  const Pose pose = any_pose();
  const PlacedPolygon robot(polygon, pose);
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      if (sampled_overlap(polygon, pose, {x, y}, kDeepEnough)) RC_ASSERT(robot.overlaps({x, y}));
    }
  }
}

/// The least distance from the corners of the polygon to the square and from those of the square to the
/// polygon: the distance of two polygons that do not overlap.
double corner_distance(const Polygon& polygon, const Pose& pose, Cell square) {
  double least = 1e9;
  for (const Point corner : polygon.corners()) {
    const Point at = test::placed(corner, pose);
    const double dx = std::max({square.x - at.x, 0.0, at.x - square.x - 1});
    const double dy = std::max({square.y - at.y, 0.0, at.y - square.y - 1});
    least = std::min(least, std::hypot(dx, dy));
  }
  for (const Point corner : {Point{0, 0}, Point{1, 0}, Point{0, 1}, Point{1, 1}}) {
    const Point at{square.x + corner.x, square.y + corner.y};
    least = std::min(least, distance_to_outline(polygon, in_robot(at, pose)));
  }
  return least;
}

RC_GTEST_PROP(PlacedPolygon, DoesNotOverlapASquareAtADistance, ()) {
  const Polygon polygon = any_polygon();
  const Pose pose = any_pose();
  const PlacedPolygon robot(polygon, pose);
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      const double gap = robot.distance_to({x, y});
      if (gap > 1e-6) {
        RC_ASSERT(!robot.overlaps({x, y}));
        RC_ASSERT(std::abs(gap - corner_distance(polygon, pose, {x, y})) < 1e-9);
      }
      if (robot.overlaps({x, y})) RC_ASSERT(gap < 1e-9);
    }
  }
}

RC_GTEST_PROP(PlacedPolygon, OverlapsAlongALineWhereItDoesSomewhereOnIt, ()) {
  const Polygon polygon = any_polygon();
  const Pose pose = any_pose();
  const Point by{*rc::gen::inRange(-12, 13) / 4.0, *rc::gen::inRange(-12, 13) / 4.0};
  const PlacedPolygon robot(polygon, pose);
  constexpr int kSamples = 200;
  for (int y = -3; y < 3; ++y) {
    for (int x = -3; x < 3; ++x) {
      bool somewhere = false;
      double nearest = 1e9;
      for (int i = 0; i <= kSamples; ++i) {
        const double share = static_cast<double>(i) / kSamples;
        const PlacedPolygon there(polygon,
                                  {pose.x + share * by.x, pose.y + share * by.y, pose.heading});
        somewhere = somewhere || there.overlaps({x, y});
        nearest = std::min(nearest, there.distance_to({x, y}));
      }
      const bool along = robot.overlaps_along(by, {x, y});
      if (somewhere) RC_ASSERT(along);
      if (nearest > std::hypot(by.x, by.y) / kSamples) RC_ASSERT(!along);
    }
  }
}

TEST(PlacedPolygon, MayTouchSquares) {
  const Polygon box = *Polygon::make({{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}});
  const PlacedPolygon robot(box, {3.5, 3.5, kPi / 2});
  EXPECT_TRUE(robot.overlaps({3, 3}));  // the same square
  EXPECT_FALSE(robot.overlaps({4, 3}));
  EXPECT_FALSE(robot.overlaps({2, 2}));
  EXPECT_FALSE(robot.overlaps_along({0, 5}, {4, 5}));  // along a wall
  EXPECT_TRUE(robot.overlaps_along({0, 5}, {3, 6}));
  EXPECT_TRUE(robot.overlaps_along({0.01, 5}, {4, 8}));
  EXPECT_FALSE(robot.overlaps_along({0.01, 5}, {4, 9}));
}

TEST(PlacedPolygon, OverlapsASquareThatItHoldsWhole) {
  const Polygon box = *Polygon::make({{5, 5}, {-5, 5}, {-5, -5}, {5, -5}});
  EXPECT_TRUE(PlacedPolygon(box, {0, 0, 1}).overlaps({1, 1}));
  EXPECT_EQ(PlacedPolygon(box, {0, 0, 1}).distance_to({1, 1}), 0);
}

}  // namespace
}  // namespace wend
