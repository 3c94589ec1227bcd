#include "wend/control/trajectory_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/control/route.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

/// How fast the time of the trajectory runs: slower for a robot that is beside it, so that a car which still
/// turns its wheels loses less way.
double pace_at(double aside, double turn) {
  constexpr double kNear = 0.02;     // m
  constexpr double kFar = 0.1;       // m
  constexpr double kAligned = 0.05;  // rad
  constexpr double kTurned = 0.15;   // rad
  constexpr double kLeast = 0.3;     // a robot far beside still gets there in time
  const double beside = (aside - kNear) / (kFar - kNear);
  const double turned = (turn - kAligned) / (kTurned - kAligned);
  return std::clamp(1 - std::max(beside, turned), kLeast, 1.0);
}

}  // namespace

TrajectoryTracker::TrajectoryTracker(Trajectory trajectory, const TrackingGains& gains)
    : trajectory_(std::move(trajectory)), gains_(gains) {}

void TrajectoryTracker::track(Trajectory trajectory) {
  trajectory_ = std::move(trajectory);
  time_ = 0;
  begun_ = false;
}

/// Is the robot turned so that the time may begin? A larger error it could not correct on the way.
bool TrajectoryTracker::begins(double turn) {
  constexpr double kAligned = radians_from(15);
  begun_ = begun_ || std::abs(turn) <= kAligned;
  return begun_;
}

Velocity TrajectoryTracker::command(const ControllerInput& input) {
  const MapPose wanted = trajectory_.at(time_).pose;
  const MapPose robot = turned_round(input.pose, input.reverse);
  const double turn = normalized_angle(wanted.heading - robot.heading);
  if (!begins(turn)) return {0, gains_.heading_gain * turn};

  const double dx = wanted.x - robot.x;
  const double dy = wanted.y - robot.y;
  const auto [sine, cosine] = sine_and_cosine(robot.heading);
  const double ahead = cosine * dx + sine * dy;
  const double left = cosine * dy - sine * dx;
  const double pace = pace_at(std::abs(left), std::abs(turn));
  // A command is held for a while: the mean velocity of that time is the one in its middle.
  const double seconds = pace * input.seconds;
  const TrajectoryState reference = trajectory_.at(time_ + seconds / 2);
  const double speed = pace * reference.speed;
  time_ += seconds;
  const double linear = speed * sine_and_cosine(turn).cosine + gains_.along_gain * ahead;
  const double angular =
      pace * reference.turn_rate + gains_.heading_gain * turn + gains_.side_gain * speed * left;
  return {input.reverse ? -linear : linear, angular};
}

}  // namespace wend
