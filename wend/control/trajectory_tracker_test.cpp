#include "wend/control/trajectory_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/control/simulation.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/corner_rounding.hpp"

namespace wend {
namespace {

constexpr VelocityLimits kRobotLimits{.speed = 1, .turn_rate = 1.5};
constexpr TrajectoryLimits kTrackedLimits{.speed = 1, .turn_rate = 1.5};

FreeSpace tracking_ground() { return test::open_space(30, 30); }

Drive tracked(const Path& path, double& duration, const SimulationOptions& simulation = {}) {
  const FreeSpace space = tracking_ground();
  const auto trajectory = Trajectory::along(path, space.map().frame(), kTrackedLimits);
  EXPECT_TRUE(trajectory);
  duration = trajectory->duration();
  TrajectoryTracker tracker(*trajectory);
  return simulate(space, path, tracker, {.limits = kRobotLimits}, simulation,
                  {.goal_tolerance = 0.05});
}

void expect_in_time(const Path& path, double cross_track) {
  double duration = 0;
  const Drive drive = tracked(path, duration);
  EXPECT_EQ(drive.outcome, DriveOutcome::reached);
  EXPECT_NEAR(drive.time, duration, 0.02 * duration + 0.2);
  EXPECT_LT(drive.cross_track_largest, cross_track);
  EXPECT_LT(drive.final_error, 0.05);
}

TEST(TrajectoryTracker, ArrivesInTimeOnALine) {
  expect_in_time(Path::along({{2, 2}, {20, 2}}), 1e-6);
}

TEST(TrajectoryTracker, ArrivesInTimeAroundCornersInPlace) {
  expect_in_time(Path::along({{2, 2}, {12, 2}, {12, 9}, {3, 14}}), 0.05);
}

TEST(TrajectoryTracker, ArrivesInTimeAroundRoundedCorners) {
  const Path path = Path::along({{2, 2}, {12, 2}, {12, 9}, {3, 14}, {3, 20}});
  expect_in_time(rounded_corners(path, tracking_ground(), 0.5), 0.1);
}

TEST(TrajectoryTracker, ArrivesInTimeInReverseAndAfterAChangeOfGear) {
  expect_in_time(Path::through({{9, 9, 0}, {5, 9, 0}, {2, 12, -kPi / 2}}), 0.1);
  expect_in_time(Path::through({{4, 4, 0}, {9, 4, 0}, {6, 7, -kPi / 2}, {6, 2, -kPi / 2}}), 0.1);
}

TEST(TrajectoryTracker, FindsBackToItsTrajectoryInSpiteOfNoise) {
  double duration = 0;
  const Path path =
      rounded_corners(Path::along({{2, 2}, {12, 2}, {12, 9}}), tracking_ground(), 0.5);
  const Drive drive = tracked(
      path, duration, {.actuation_noise = 0.05, .position_noise = 0.01, .heading_noise = 0.01});
  EXPECT_EQ(drive.outcome, DriveOutcome::reached);
  EXPECT_NEAR(drive.time, duration, 0.05 * duration + 0.5);
  EXPECT_LT(drive.cross_track_largest, 0.15);
}

TEST(TrajectoryTracker, DrivesAtTheSpeedOfTheTrajectory) {
  double duration = 0;
  const Drive drive = tracked(Path::along({{2, 2}, {20, 2}}), duration);
  for (const DriveSample& sample : drive.samples) {
    if (sample.time < 1.2 || sample.time > duration - 1.2) continue;
    EXPECT_NEAR(sample.velocity.linear, kTrackedLimits.speed, 1e-6) << sample.time;
    EXPECT_NEAR(sample.pose.x, 2.5 + (sample.time - 1), 0.01) << sample.time;
  }
}

}  // namespace
}  // namespace wend
