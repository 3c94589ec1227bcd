#include "wend/control/trajectory_tracker.hpp"

#include <cmath>
#include <utility>

#include "wend/control/route.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {

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

  // A command is held for a while: the mean velocity of that time is the one in its middle.
  const TrajectoryState reference = trajectory_.at(time_ + input.seconds / 2);
  time_ += input.seconds;
  const double dx = wanted.x - robot.x;
  const double dy = wanted.y - robot.y;
  const auto [sine, cosine] = sine_and_cosine(robot.heading);
  const double ahead = cosine * dx + sine * dy;
  const double left = cosine * dy - sine * dx;
  const double linear = reference.speed * sine_and_cosine(turn).cosine + gains_.along_gain * ahead;
  const double angular =
      reference.turn_rate + gains_.heading_gain * turn + gains_.side_gain * reference.speed * left;
  return {input.reverse ? -linear : linear, angular};
}

}  // namespace wend
