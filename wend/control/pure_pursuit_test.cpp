// Pure pursuit with the default gains on tracks that it was not tuned for: it brakes in time for
// its limits and stays near the line at any speed limit.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/control/simulation.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr double kResolution = 0.05;  // m

FreeSpace race_ground() {
  return *make_free_space(*make_grid_map(
      Grid<CellState>(1200, 1200),
      Frame{.resolution = kResolution, .origin = {0, 0, 0}, .y_up = true, .metric = true}));
}

/// In metres, around the middle of the map.
Path track(std::vector<Point> points) {
  for (Point& point : points) point = {600 + point.x / kResolution, 600 + point.y / kResolution};
  return Path::along(std::move(points));
}

/// Two straights of 20 m and half a circle at either end.
Path stadium(double radius) {
  std::vector<Point> points;
  for (int i = 0; i <= 24; ++i) {
    const double angle = -kPi / 2 + kPi * i / 24;
    points.push_back({10 + radius * std::cos(angle), radius * std::sin(angle)});
  }
  for (int i = 0; i <= 24; ++i) {
    const double angle = kPi / 2 + kPi * i / 24;
    points.push_back({-10 + radius * std::cos(angle), radius * std::sin(angle)});
  }
  return track(std::move(points));
}

/// A circle whose radius swings, from a seed: bends to either side, of any radius from 0.8 m on.
Path wild_track(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  const double few = 2 + static_cast<double>(random.below(3));
  const double many = 5 + static_cast<double>(random.below(4));
  const double phase = random.uniform() * 2 * kPi;
  for (int i = 0; i < 400; ++i) {
    const double angle = 2 * kPi * i / 400;
    const double radius = 18 + 4 * std::cos(few * angle) + 2 * std::cos(many * angle + phase);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return track(std::move(points));
}

Drive lap(const Path& path, const MotionModel& model) {
  const auto controller = make_controller("pure_pursuit").value();
  return simulate(race_ground(), path, *controller, model, {.closed = true});
}

std::vector<MotionModel> robots() {
  std::vector<MotionModel> robots;
  for (const Drivetrain drivetrain : {Drivetrain::differential, Drivetrain::bicycle}) {
    for (const double speed : {0.5, 3.0, 6.0}) {
      robots.push_back({.drivetrain = drivetrain, .limits = {.speed = speed}});
    }
  }
  return robots;
}

TEST(PurePursuit, BrakesForTheHairpinsOfAStadium) {
  for (const MotionModel& robot : robots()) {
    for (const double radius : {0.8, 2.0, 5.0}) {
      const Drive drive = lap(stadium(radius), robot);
      SCOPED_TRACE(std::to_string(robot.limits.speed) + " m/s, " + std::to_string(radius) + " m");
      EXPECT_EQ(drive.outcome, DriveOutcome::reached);
      EXPECT_LT(drive.cross_track_largest, 0.06);
    }
  }
}

TEST(PurePursuit, KeepsToWildTracks) {
  for (const MotionModel& robot : robots()) {
    for (std::uint64_t seed = 1; seed <= test::share_of(5U); ++seed) {
      const Drive drive = lap(wild_track(seed), robot);
      SCOPED_TRACE(std::to_string(robot.limits.speed) + " m/s, seed " + std::to_string(seed));
      EXPECT_EQ(drive.outcome, DriveOutcome::reached);
      EXPECT_LT(drive.cross_track_largest, 0.06);
    }
  }
}

TEST(PurePursuit, DrivesFasterWhereItMay) {
  MotionModel slow{.limits = {.speed = 0.5}};
  MotionModel fast{.limits = {.speed = 3}};
  EXPECT_LT(lap(stadium(5), fast).time, 0.4 * lap(stadium(5), slow).time);
}

/// The heading error that is shown follows the curve, not the lines between its points.
TEST(Simulate, ShowsNoSawOfHeadingErrors) {
  std::vector<Point> points;
  for (int i = 0; i < 36; ++i) {
    const double angle = kPi * i / 18;
    points.push_back({5 * std::cos(angle), 5 * std::sin(angle)});
  }
  const Drive drive = lap(track(points), {});
  double largest = 0;
  for (std::size_t i = drive.samples.size() / 10; i < drive.samples.size() * 9 / 10; ++i) {
    largest = std::max(largest, std::abs(drive.samples[i].heading_error));
  }
  EXPECT_LT(degrees_from(largest), 4) << "the lines turn by 10 degrees at each point";
}

}  // namespace
}  // namespace wend
