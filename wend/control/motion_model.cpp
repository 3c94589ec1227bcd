#include "wend/control/motion_model.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

/// How a robot moves over the ground: its speed, or if it moves to its sides, the greatest of a circle.
struct Planar {
  double ahead;
  double left;
};

Planar shortened(const Planar& vector, double most) {
  const double length = hypotenuse(vector.ahead, vector.left);
  if (length <= most) return vector;
  return {vector.ahead * most / length, vector.left * most / length};
}

Planar limited(const Planar& wanted, const Planar& now, const VelocityLimits& limits,
               double seconds) {
  const Planar within = shortened(wanted, limits.speed);
  const Planar change =
      shortened({within.ahead - now.ahead, within.left - now.left}, limits.acceleration * seconds);
  return {now.ahead + change.ahead, now.left + change.left};
}

double limited(double wanted, double now, double greatest, double change) {
  return std::clamp(std::clamp(wanted, -greatest, greatest), now - change, now + change);
}

}  // namespace

Velocity limited(const Velocity& wanted, const Velocity& now, const VelocityLimits& limits,
                 double seconds) {
  const double angular =
      limited(wanted.angular, now.angular, limits.turn_rate, limits.turn_acceleration * seconds);
  if (wanted.lateral == 0 && now.lateral == 0) {
    return {limited(wanted.linear, now.linear, limits.speed, limits.acceleration * seconds),
            angular};
  }
  const Planar planar = limited(Planar{wanted.linear, wanted.lateral},
                                Planar{now.linear, now.lateral}, limits, seconds);
  // Braked to a stop but for rounding is a stop.
  constexpr double kStanding = 1e-12;
  if (hypotenuse(planar.ahead, planar.left) < kStanding) return {0, angular};
  return {planar.ahead, angular, planar.left};
}

double MotionModel::turning_radius() const {
  return drivetrain == Drivetrain::bicycle ? wheelbase / tangent(steering_limit) : 0;
}

Step hold(const MapPose& from, const Velocity& velocity, double seconds) {
  constexpr double kStanding = 1e-9;
  const double speed = velocity.lateral == 0 ? std::abs(velocity.linear)
                                             : hypotenuse(velocity.linear, velocity.lateral);
  if (speed < kStanding) {
    const double heading = normalized_angle(from.heading + velocity.angular * seconds);
    return {{from, 0, 0}, {{from.x, from.y, heading}, velocity}};
  }
  const double gear = velocity.linear < 0 ? -1 : 1;
  const double course =
      velocity.lateral == 0 ? 0 : arc_tangent(gear * velocity.lateral, gear * velocity.linear);
  const MapArc arc{{from.x, from.y, from.heading + course},
                   gear * speed * seconds,
                   velocity.angular / (gear * speed)};
  MapPose end = end_of(arc);
  if (course != 0) end.heading = normalized_angle(end.heading - course);
  return {arc, {end, velocity}, course};
}

Step drive(const MotionModel& model, const RobotState& from, const Velocity& wanted,
           double seconds) {
  Velocity possible = wanted;
  if (model.drivetrain != Drivetrain::omni) possible.lateral = 0;
  Velocity velocity = limited(possible, from.velocity, model.limits, seconds);
  if (const double radius = model.turning_radius(); radius > 0) {
    const double change = model.limits.turn_acceleration * seconds;
    const double slowest = radius * (std::abs(from.velocity.angular) - change);
    if (std::abs(velocity.linear) < slowest) {
      velocity.linear = std::copysign(slowest, from.velocity.linear);
    }
    const double fastest_turn = std::abs(velocity.linear) / radius;
    velocity.angular = std::clamp(velocity.angular, -fastest_turn, fastest_turn);
  }
  return hold(from.pose, velocity, seconds);
}

}  // namespace wend
