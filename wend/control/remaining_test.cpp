#include "wend/control/remaining.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/polyline.hpp"

namespace wend {
namespace {

TEST(Remaining, BeginsAtTheNearestPoint) {
  const Remaining rest = remaining(Path({{0, 0}, {1, 0}, {2, 0}, {2, 1}}), {1.75, 0.25, 0});
  EXPECT_EQ(rest.path, Path::along({{1.75, 0.5}, {2.5, 0.5}, {2.5, 1.5}}));
  EXPECT_EQ(rest.along, 1.25);
  EXPECT_EQ(rest.distance, 0.25);
}

TEST(Remaining, OfAPathNotYetBegunIsAllOfIt) {
  const std::vector<Point> points{{0, 0}, {3, 0}, {3, 4}};
  const Remaining rest = remaining(Path::along(points), {-1, 0, 0});
  EXPECT_EQ(rest.path, Path::along(points));
  EXPECT_EQ(rest.along, 0);
  EXPECT_EQ(rest.distance, 1);
}

TEST(Remaining, AtTheEndIsThatPoint) {
  const Remaining rest = remaining(Path::along({{0, 0}, {3, 0}}), {5, 0, 0});
  EXPECT_EQ(rest.path, Path::along({{3, 0}}));
  EXPECT_EQ(rest.along, 3);
  EXPECT_EQ(rest.distance, 2);
}

TEST(Remaining, OfASinglePointIsThatPoint) {
  const Remaining rest = remaining(Path({{1, 1}}), {1.5, 3.5, 0});
  EXPECT_EQ(rest.path, Path::along({{1.5, 1.5}}));
  EXPECT_EQ(rest.along, 0);
  EXPECT_EQ(rest.distance, 2);
}

TEST(Remaining, NeverGoesBack) {
  const Path path = Path::along({{0, 0}, {9, 0}});
  const Remaining rest = remaining(path, {2, 0, 0}, 5);
  EXPECT_EQ(rest.along, 5);
  EXPECT_EQ(rest.path, Path::along({{5, 0}, {9, 0}}));
  EXPECT_EQ(rest.distance, 3);
  EXPECT_EQ(remaining(path, {2, 0, 0}, 50).path, Path::along({{9, 0}})) << "beyond the end";
}

TEST(Remaining, ThereAndBackGoesByWhereTheRobotFaces) {
  const Path path = Path::along({{0, 0}, {9, 0}, {0, 0}});
  EXPECT_EQ(remaining(path, {4, 0, 0}).along, 4);
  EXPECT_EQ(remaining(path, {4, 0, kPi}).along, 14);
  EXPECT_EQ(remaining(path, {4, 0, 0}, 9).along, 14);
}

/// Twice round, ever wider, two cells from turn to turn.
Path spiral() {
  std::vector<Point> points;
  for (int i = 0; i <= 200; ++i) {
    const double angle = 4 * kPi * i / 200;
    const double radius = 3 + angle / kPi;
    points.push_back({20 + radius * std::cos(angle), 20 + radius * std::sin(angle)});
  }
  return Path::along(points);
}

Path eight() {
  std::vector<Point> points;
  for (int i = 0; i <= 200; ++i) {
    const double angle = 2 * kPi * i / 200;
    points.push_back({20 + 12 * std::sin(angle), 20 + 6 * std::sin(2 * angle)});
  }
  return Path::along(points);
}

/// A robot that drives along, a little off and askew, and asks for the rest as it goes.
void expect_kept_up(const Path& path, double off) {
  const Polyline line = Polyline::of(path);
  double along = 0;
  for (double true_along = 0; true_along < line.length(); true_along += 0.5) {
    Pose pose = line.at(true_along);
    pose.x -= off * std::sin(pose.heading);
    pose.y += off * std::cos(pose.heading);
    pose.heading += off;
    const Remaining rest = remaining(path, pose, along);
    EXPECT_GE(rest.along, along);
    EXPECT_NEAR(rest.along, true_along, 0.5) << "at " << true_along << " of " << line.length();
    along = rest.along;
  }
}

TEST(Remaining, SkipsNoLoop) {
  for (const double off : {-0.4, 0.0, 0.4}) {
    expect_kept_up(spiral(), off);
    expect_kept_up(eight(), off);
    expect_kept_up(Path::along({{0, 0}, {30, 0}, {30, 2.5}, {0, 2.5}, {0, 5}, {30, 5}}), off);
  }
}

TEST(Remaining, FindsItsPlaceInALoopByTheHeading) {
  const Path path = eight();  // crosses itself in (20, 20): first to the upper right
  const double half = Polyline::of(path).length() / 2;
  EXPECT_NEAR(remaining(path, {20, 20, kPi / 4}).along, 0, 0.1);
  EXPECT_NEAR(remaining(path, {20, 20, kPi * 3 / 4}).along, half, 0.1);
}

TEST(Remaining, OfADriveAreItsPoses) {
  // A quarter circle of radius 4, then in reverse.
  const Path path = Path::through({{0, 0, 0}, {4, 4, kPi / 2}, {4, 1, kPi / 2}});
  const Pose half{4 * std::sin(kPi / 4), 4 - 4 * std::cos(kPi / 4), kPi / 4};
  const Remaining rest = remaining(path, half);
  ASSERT_EQ(rest.path.driven_poses().size(), 3U);
  const Pose first = rest.path.driven_poses().front();
  EXPECT_NEAR(distance(first.point(), half.point()), 0, 0.01);
  EXPECT_NEAR(first.heading, kPi / 4, 0.01);
  EXPECT_NEAR(rest.along, kPi, 0.01);
  EXPECT_NEAR(rest.path.length(), kPi + 3, 0.01);
  EXPECT_NEAR(rest.path.arcs()[0].curvature, 0.25, 1e-9) << "on the same circle";

  const Remaining back = remaining(path, {4, 2, kPi / 2}, 2 * kPi);
  EXPECT_NEAR(back.path.length(), 1, 1e-9);
  EXPECT_NEAR(distance(back.path.points().front(), {4, 2}), 0, 1e-9);
  EXPECT_NEAR(back.along, 2 * kPi + 2, 1e-9);
}

/// Of any kind, with points on top of each other now and then.
Path random_path(Random& random) {
  const int count = random.between(1, 10);
  const auto coordinate = [&] { return 10 * random.uniform(); };
  if (random.chance(0.3)) {
    std::vector<Cell> cells{{random.between(0, 9), random.between(0, 9)}};
    for (int i = 1; i < count; ++i) {
      cells.push_back(
          {cells.back().x + random.between(-1, 1), cells.back().y + random.between(-1, 1)});
    }
    return Path(cells);
  }
  if (random.chance(0.4)) {
    std::vector<Pose> poses{{coordinate(), coordinate(), 6 * random.uniform()}};
    for (int i = 1; i < count; ++i) {
      const double length = random.chance(0.1) ? 0 : 8 * random.uniform() - 4;
      const double curvature = random.chance(0.3) ? 0 : random.uniform() - 0.5;
      poses.push_back(end_of({poses.back(), length, curvature}));
    }
    return Path::through(poses);
  }
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(random.chance(0.1) && !points.empty() ? points.back()
                                                           : Point{coordinate(), coordinate()});
  }
  return Path::along(points);
}

RC_GTEST_PROP(Remaining, IsTheEndOfThePath, (std::uint64_t seed)) {
  Random random(seed);
  const Path path = random_path(random);
  const double length = path.length();
  const Pose pose{12 * random.uniform() - 1, 12 * random.uniform() - 1, 7 * random.uniform()};
  const double from = random.uniform() * length;
  const Remaining rest = remaining(path, pose, from);
  constexpr double kRounding = 1e-9;
  RC_ASSERT(rest.along >= from);
  RC_ASSERT(rest.along <= length + kRounding);
  RC_ASSERT(!rest.path.empty());
  RC_ASSERT(rest.path.driven() == path.driven());
  RC_ASSERT(std::abs(rest.path.length() - (length - rest.along)) < kRounding * (1 + length));
  RC_ASSERT(distance(rest.path.points().back(), path.points().back()) < kRounding);
  const Point first = rest.path.points().front();
  RC_ASSERT(std::abs(rest.distance - distance(first, pose.point())) < kRounding);
  // As near as the nearest of fine samples of what was ahead, or as another visit within a cell.
  double nearest = rest.distance;
  double before = 0;
  for (const Arc& arc : path.arcs()) {
    constexpr int kSamples = 200;
    for (int i = 0; i <= kSamples; ++i) {
      const double driven = arc.length * i / kSamples;
      if (before + std::abs(driven) < from) continue;
      nearest = std::min(nearest, distance(point_on(arc, driven), pose.point()));
    }
    before += std::abs(arc.length);
  }
  constexpr double kTie = 1;
  constexpr double kChords = 0.03;
  RC_ASSERT(rest.distance <= nearest + kTie + kChords);
}

RC_GTEST_PROP(Remaining, AskedAgainStaysThere, (std::uint64_t seed)) {
  Random random(seed);
  const Path path = random_path(random);
  RC_PRE(!path.driven());  // the chords of its arcs lie beside them
  const Pose pose{12 * random.uniform() - 1, 12 * random.uniform() - 1, 7 * random.uniform()};
  const Remaining rest = remaining(path, pose);
  // Whatever else is near, it comes first.
  const Point first = rest.path.points().front();
  const Remaining again =
      remaining(path, {first.x, first.y, rest.path.poses().front().heading}, rest.along);
  RC_ASSERT(again.along >= rest.along);
  RC_ASSERT(again.along - rest.along < 0.05);
}

}  // namespace
}  // namespace wend
