#include "wend/control/nearest_ahead.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/polyline.hpp"

namespace wend {
namespace {

Polyline line_of(const std::vector<Point>& points) { return Polyline(points); }

TEST(NearestAhead, IsTheNearestPlace) {
  const Polyline line = line_of({{0, 0}, {10, 0}});
  const OnPolyline place = nearest_ahead(line, {3, 2, 0}, {0, 10, 1});
  EXPECT_EQ(place.along, 3);
  EXPECT_EQ(place.point, (Point{3, 0}));
  EXPECT_EQ(place.distance, 2);
}

TEST(NearestAhead, StaysInReach) {
  const Polyline line = line_of({{0, 0}, {10, 0}, {10, 10}});
  EXPECT_EQ(nearest_ahead(line, {3, 2, 0}, {5, 9, 1}).along, 5);
  EXPECT_EQ(nearest_ahead(line, {9, 9, 0}, {0, 2, 1}).along, 2);
  EXPECT_EQ(nearest_ahead(line, {9, 9, 0}, {0, 99, 1}).along, 19);
  EXPECT_EQ(nearest_ahead(line, {-9, -9, 0}, {20, 99, 1}).along, 20);
  EXPECT_EQ(nearest_ahead(line, {-9, -9, 0}, {50, 99, 1}).along, 20) << "beyond the end";
}

TEST(NearestAhead, OnASinglePointIsThatPoint) {
  const OnPolyline place = nearest_ahead(line_of({{1, 2}}), {4, 6, 0}, {0, 9, 1});
  EXPECT_EQ(place.along, 0);
  EXPECT_EQ(place.distance, 5);
}

TEST(NearestAhead, ThereAndBackGoesByWhereTheRobotFaces) {
  const Polyline line = line_of({{0, 0}, {9, 0}, {0, 0}});
  EXPECT_EQ(nearest_ahead(line, {4, 0.1, 0}, {0, 18, 1}).along, 4);
  EXPECT_EQ(nearest_ahead(line, {4, 0.1, kPi}, {0, 18, 1}).along, 14);
  EXPECT_EQ(nearest_ahead(line, {4, 0.1, 0}, {9, 18, 1}).along, 14) << "there is behind it";
  EXPECT_EQ(nearest_ahead(line, {8.8, 0.1, 0}, {0, 18, 1}).along, 8.8) << "both are one visit";
}

TEST(NearestAhead, InReverseTheBackLeads) {
  const Polyline line = line_of({{0, 0}, {9, 0}, {0, 0}});
  const std::array<std::int8_t, 2> gears{1, -1};
  EXPECT_EQ(nearest_ahead(line, {4, 0, 0}, {0, 18, 1}, gears).along, 4);
  EXPECT_EQ(nearest_ahead(line, {4, 0, kPi}, {0, 18, 1}, gears).along, 4) << "no visit leads there";
  const std::array<std::int8_t, 2> back_first{-1, 1};
  EXPECT_EQ(nearest_ahead(line, {4, 0, kPi}, {0, 18, 1}, back_first).along, 4);
}

/// Right through the middle, a loop to the left, and up through the middle again.
const std::vector<Point> kLoop{{-9, 0}, {9, 0}, {9, 9}, {0, 9}, {0, -9}};

TEST(NearestAhead, SkipsNoLoopWhereALineCrossesItself) {
  const Polyline line = line_of(kLoop);
  EXPECT_EQ(nearest_ahead(line, {0.1, 0.1, 0}, {0, 99, 1}).along, 9.1);
  EXPECT_EQ(nearest_ahead(line, {0.1, 0.1, -kPi / 4}, {0, 99, 1}).along, 9.1);
  EXPECT_NEAR(nearest_ahead(line, {0.1, 0.1, -kPi * 3 / 4}, {0, 99, 1}).along, 44.9, 1e-12);
  EXPECT_NEAR(nearest_ahead(line, {0.1, 0.1, 0}, {30, 99, 1}).along, 44.9, 1e-12);
  EXPECT_EQ(nearest_ahead(line, {0.1, 0.1, kPi * 3 / 4}, {0, 99, 1}).along, 9.1) << "none leads";
}

TEST(NearestAhead, TakesBendsNearTheRobotForOneVisit) {
  // Stairs: of several steps that are about as near, the nearest.
  std::vector<Point> stairs;
  for (int i = 0; i < 20; ++i) {
    stairs.push_back({1.0 * i, 1.0 * i});
    stairs.push_back({1.0 * i + 1, 1.0 * i});
  }
  const Polyline line = line_of(stairs);
  const OnPolyline place = nearest_ahead(line, {10.2, 9.9, kPi / 4}, {0, 99, 2});
  EXPECT_NEAR(place.distance, 0.1, 1e-12);
  EXPECT_NEAR(place.along, 20.2, 1e-12);
}

std::vector<Point> random_points(Random& random) {
  std::vector<Point> points;
  for (int i = random.between(2, 12); i > 0; --i) {
    points.push_back({10 * random.uniform(), 10 * random.uniform()});
  }
  return points;
}

RC_GTEST_PROP(NearestAhead, IsWithinTheTieOfTheNearest, (std::uint64_t seed)) {
  Random random(seed);
  const Polyline line = line_of(random_points(random));
  const Pose pose{12 * random.uniform() - 1, 12 * random.uniform() - 1, 7 * random.uniform()};
  const double from = random.uniform() * line.length();
  const Reach reach{from, from + random.uniform() * line.length(),
                    random.chance(0.3) ? 0 : random.uniform()};
  const OnPolyline place = nearest_ahead(line, pose, reach);
  RC_ASSERT(place.along >= reach.from);
  RC_ASSERT(place.along <= std::min(reach.to, line.length()));
  RC_ASSERT(std::abs(place.distance - distance(place.point, pose.point())) < 1e-12);
  RC_ASSERT(distance(place.point, line.at(place.along).point()) < 1e-9);
  const double nearest = line.nearest(pose.point(), reach.from, reach.to).distance;
  RC_ASSERT(place.distance >= nearest - 1e-12);
  RC_ASSERT(place.distance <= nearest + reach.tie + 1e-9);
}

constexpr double kSpacing = 2e-3;  // of samples

/// The nearest sample of each visit: of each stretch of a line no farther from a point than `limit`.
std::vector<double> visits_by_samples(const Polyline& line, Point point, double limit) {
  std::vector<double> visits;
  double nearest = limit;  // of this visit
  bool in_visit = false;
  for (double along = 0; along <= line.length(); along += kSpacing) {
    const double gap = distance(line.at(along).point(), point);
    const bool is_in = gap <= limit;
    if (is_in && !in_visit) visits.push_back(along);
    if (is_in && (!in_visit || gap < nearest)) {
      visits.back() = along;
      nearest = gap;
    }
    in_visit = is_in;
  }
  return visits;
}

RC_GTEST_PROP(NearestAhead, ChoosesAsSamplesDo, (std::uint64_t seed)) {
  Random random(seed);
  const Polyline line = line_of(random_points(random));
  const Pose pose{10 * random.uniform(), 10 * random.uniform(), 7 * random.uniform()};
  const double tie = 0.2 + random.uniform();
  const double limit = line.nearest(pose.point(), 0, line.length()).distance + tie;
  const std::vector<double> visits = visits_by_samples(line, pose.point(), limit);
  const auto leads = [&](double along) {
    return std::cos(line.at(along).heading - pose.heading) >= 0;
  };
  // Samples say nothing of visits that all but touch, nor of corners where the line turns away.
  RC_PRE(visits_by_samples(line, pose.point(), limit + 2 * kSpacing).size() == visits.size());
  RC_PRE(visits_by_samples(line, pose.point(), limit - 2 * kSpacing).size() == visits.size());
  RC_PRE(std::all_of(visits.begin(), visits.end(), [&](double along) {
    return leads(along - kSpacing) == leads(along + kSpacing);
  }));
  const auto leading = std::find_if(visits.begin(), visits.end(), leads);
  const double expected = leading == visits.end() ? visits.front() : *leading;
  const OnPolyline place = nearest_ahead(line, pose, {0, line.length(), tie});
  RC_ASSERT(std::abs(place.distance - distance(line.at(expected).point(), pose.point())) <
            2 * kSpacing);
}

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
  const Polyline line = polyline_of(path);
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
  const double half = polyline_of(path).length() / 2;
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
