#pragma once

// Angles in radians, counter-clockwise from +x.

#include <numbers>

namespace wend {

inline constexpr double kPi = std::numbers::pi;

/// The same direction in (-pi, pi].
double normalized_angle(double radians);

constexpr double degrees_from(double radians) { return radians * (180 / kPi); }
constexpr double radians_from(double degrees) { return degrees * (kPi / 180); }

}  // namespace wend
