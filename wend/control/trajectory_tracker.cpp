#include "wend/control/trajectory_tracker.hpp"

#include <cmath>
#include <utility>

#include "wend/geometry/angle.hpp"

namespace wend {

TrajectoryTracker::TrajectoryTracker(Trajectory trajectory, const TrackingGains& gains)
    : trajectory_(std::move(trajectory)), gains_(gains) {}

Velocity TrajectoryTracker::command(const ControllerInput& input) {
  const MapPose wanted = trajectory_.at(time_).pose;
  // A command is held for a while: the mean velocity of that time is the one in its middle.
  const TrajectoryState reference = trajectory_.at(time_ + input.seconds / 2);
  time_ += input.seconds;

  // On a reverse leg the robot is shown turned round.
  const bool round = std::abs(normalized_angle(wanted.heading - input.pose.heading)) > kPi / 2;
  const double heading = input.pose.heading + (round ? kPi : 0);
  const double dx = wanted.x - input.pose.x;
  const double dy = wanted.y - input.pose.y;
  const double ahead = std::cos(heading) * dx + std::sin(heading) * dy;
  const double left = std::cos(heading) * dy - std::sin(heading) * dx;
  const double turn = normalized_angle(wanted.heading - heading);

  const double linear = reference.speed * std::cos(turn) + gains_.along_gain * ahead;
  const double angular =
      reference.turn_rate + gains_.heading_gain * turn + gains_.side_gain * reference.speed * left;
  return {round ? -linear : linear, angular};
}

}  // namespace wend
