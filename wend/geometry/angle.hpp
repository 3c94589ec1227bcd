#pragma once

// Angles in radians, counter-clockwise from +x.

#include <cmath>
#include <numbers>

namespace wend {

inline constexpr double kPi = std::numbers::pi;  // half a turn

/// The same direction in (-pi, pi].
inline double normalized_angle(double radians) {
  const double wrapped = std::remainder(radians, 2 * kPi);  // in [-pi, pi]
  return wrapped == -kPi ? kPi : wrapped;
}

/// Converts radians to degrees.
constexpr double degrees_from(double radians) { return radians * (180 / kPi); }
/// Converts degrees to radians.
constexpr double radians_from(double degrees) { return degrees * (kPi / 180); }

}  // namespace wend
