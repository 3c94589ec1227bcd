#include "wend/control/motion_model.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

double limited(double wanted, double now, double greatest, double change) {
  return std::clamp(std::clamp(wanted, -greatest, greatest), now - change, now + change);
}

}  // namespace

Velocity limited(const Velocity& wanted, const Velocity& now, const VelocityLimits& limits,
                 double seconds) {
  return {
      limited(wanted.linear, now.linear, limits.speed, limits.acceleration * seconds),
      limited(wanted.angular, now.angular, limits.turn_rate, limits.turn_acceleration * seconds)};
}

double MotionModel::turning_radius() const {
  return drivetrain == Drivetrain::differential ? 0 : wheelbase / tangent(steering_limit);
}

Step hold(const MapPose& from, const Velocity& velocity, double seconds) {
  constexpr double kStanding = 1e-9;
  if (std::abs(velocity.linear) < kStanding) {
    const double heading = normalized_angle(from.heading + velocity.angular * seconds);
    return {{from, 0, 0}, {{from.x, from.y, heading}, velocity}};
  }
  const MapArc arc{from, velocity.linear * seconds, velocity.angular / velocity.linear};
  return {arc, {end_of(arc), velocity}};
}

Step drive(const MotionModel& model, const RobotState& from, const Velocity& wanted,
           double seconds) {
  Velocity velocity = limited(wanted, from.velocity, model.limits, seconds);
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
