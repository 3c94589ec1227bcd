#include "wend/control/nearest_ahead.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

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

}  // namespace
}  // namespace wend
