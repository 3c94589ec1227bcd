#include "wend/control/velocity.hpp"

#include <algorithm>

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

}  // namespace wend
