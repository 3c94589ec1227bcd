#include "wend/control/trajectory_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/control/simulation.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/smoothing/corner_rounding.hpp"

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
  expect_in_time(*rounded_corners(path, tracking_ground(), 0.5), 0.1);
}

TEST(TrajectoryTracker, ArrivesInTimeInReverseAndAfterAChangeOfGear) {
  expect_in_time(Path::through({{9, 9, 0}, {5, 9, 0}, {2, 12, -kPi / 2}}), 0.1);
  expect_in_time(Path::through({{4, 4, 0}, {9, 4, 0}, {6, 7, -kPi / 2}, {6, 2, -kPi / 2}}), 0.1);
}

TEST(TrajectoryTracker, ArrivesInTimeAfterTurnsInPlace) {
  expect_in_time(
      Path::through({{4, 4, 0}, {9, 4, 0}, {9, 4, kPi / 2}, {9, 9, kPi / 2}, {9, 9, 0}, {6, 9, 0}}),
      0.1);
}

TEST(TrajectoryTracker, FindsBackToItsTrajectoryInSpiteOfNoise) {
  double duration = 0;
  const Path path =
      *rounded_corners(Path::along({{2, 2}, {12, 2}, {12, 9}}), tracking_ground(), 0.5);
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

/// Where a robot gets that faces any way at first, and whether it was beside the line on its way.
void expect_turns_first(const Path& path, const MapPose& from) {
  const auto trajectory = Trajectory::along(path, Frame{}, kTrackedLimits);
  ASSERT_TRUE(trajectory);
  TrajectoryTracker tracker(*trajectory);
  Follower follower(tracker, kRobotLimits, {.goal_tolerance = 0.05});
  follower.follow(Route(path, Frame{}));
  RobotState robot{from};
  FollowerStep step{.state = FollowerState::driving};
  for (int i = 0; i < 2000 && step.state == FollowerState::driving; ++i) {
    step = follower.step(robot.pose, 0.05);
    EXPECT_LT(step.cross_track, 0.15);
    const double turned = normalized_angle(robot.pose.heading - path.poses().front().heading);
    if (std::abs(turned) > 0.3 && tracker.time() == 0) {
      EXPECT_EQ(step.command.linear, 0);
    }
    robot = drive({.limits = kRobotLimits}, robot, step.command, 0.05).to;
  }
  EXPECT_EQ(step.state, FollowerState::reached);
  EXPECT_LT(distance(robot.pose.point(), trajectory->at(99).pose.point()), 0.06);
  EXPECT_LT(std::abs(normalized_angle(robot.pose.heading - path.poses().back().heading)), 0.2)
      << "it did not drive in reverse, nor the other way round";
}

TEST(TrajectoryTracker, TurnsToTheTrajectoryBeforeItStarts) {
  for (const double heading : {0.1, 1.0, 1.8, 3.0, -2.0, -0.5}) {
    SCOPED_TRACE(heading);
    expect_turns_first(Path::along({{2, 2}, {9, 2}}), {2, 2, heading});
    expect_turns_first(Path::through({{9, 2, 0}, {2, 2, 0}}), {9, 2, heading});
  }
}

TEST(TrajectoryTracker, TracksAnotherTrajectoryFromItsStart) {
  const auto first = Trajectory::along(Path::along({{0, 0}, {9, 0}}), Frame{}, kTrackedLimits);
  const auto second = Trajectory::along(Path::along({{3, 0}, {3, 9}}), Frame{}, kTrackedLimits);
  ASSERT_TRUE(first && second);
  TrajectoryTracker tracker(*first);
  const MapPolyline line({{0, 0}, {9, 0}});
  for (int i = 0; i < 50; ++i) tracker.command({{0, 0, 0}, {}, &line, 0, 1, 0.1, {}});
  EXPECT_NEAR(tracker.time(), 5, 1e-9);
  tracker.track(*second);
  EXPECT_EQ(tracker.time(), 0);
  const Velocity command = tracker.command({{3, 0, 0}, {}, &line, 0, 1, 0.1, {}});
  EXPECT_EQ(command.linear, 0) << "it turns first";
  EXPECT_GT(command.angular, 0);
  EXPECT_EQ(tracker.time(), 0);
}

}  // namespace
}  // namespace wend
