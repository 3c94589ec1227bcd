#include "wend_ros/tracking.hpp"

#include <cmath>
#include <sstream>

#include "wend/geometry/angle.hpp"

namespace wend_ros {
namespace {

/// Between two samples the robot may turn and drive on: what looks like a small step to the side is a
/// corner.
bool steps_aside(const wend::MapSegment& segment) {
  constexpr double kCorner = 0.02;  // m
  constexpr double kCourse = wend::radians_from(30);
  return std::abs(segment.length) > kCorner && std::abs(segment.course) > kCourse;
}

std::string rounded(double number) {
  constexpr int kDigits = 3;
  std::ostringstream text;
  text.precision(kDigits);
  text << number;
  return text.str();
}

std::string fault_of(double speed, double limit, const std::string& unit, const std::string& name) {
  constexpr double kRounding = 1.01;
  if (speed <= kRounding * limit) return {};
  return "it needs " + rounded(speed) + " " + unit + ", and ~" + name + " is " + rounded(limit);
}

}  // namespace

std::string why_untrackable(const wend::Trajectory& trajectory,
                            const wend::VelocityLimits& limits) {
  for (const wend::MapSegment& segment : trajectory.segments()) {
    if (!steps_aside(segment)) continue;
    return "it moves to the side at (" + rounded(segment.from.x) + ", " + rounded(segment.from.y) +
           "), and the robot cannot";
  }
  const wend::TrajectoryLimits& needed = trajectory.limits();
  const std::string too_fast = fault_of(needed.speed, limits.speed, "m/s", "speed");
  return too_fast.empty() ? fault_of(needed.turn_rate, limits.turn_rate, "rad/s", "turn_rate")
                          : too_fast;
}

}  // namespace wend_ros
