#include "wend_ros/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "wend/geometry/angle.hpp"

namespace wend_ros {
namespace {

std::string rounded(double number) {
  constexpr int kDigits = 4;
  std::ostringstream text;
  text.precision(kDigits);
  text << number;
  return text.str();
}

wend::Unexpected<std::string> fault(const Orientation& turn, const std::string& what) {
  return wend::Unexpected<std::string>("has the orientation (" + rounded(turn.x) + ", " +
                                       rounded(turn.y) + ", " + rounded(turn.z) + ", " +
                                       rounded(turn.w) + "), " + what);
}

/// With the length 1, or why it is not nearly so.
wend::Expected<Orientation, std::string> normalised(const Orientation& turn) {
  const double length = std::hypot(std::hypot(turn.x, turn.y), std::hypot(turn.z, turn.w));
  if (!std::isfinite(length)) return wend::Unexpected<std::string>("contains NaN or infinity");
  if (std::abs(length - 1) > kLengthTolerance) {
    return fault(turn, "whose length is " + rounded(length) + ", not 1");
  }
  return Orientation{turn.x / length, turn.y / length, turn.z / length, turn.w / length};
}

/// Between +z and the vertical, rad, of a normalised orientation.
double tilt_of(const Orientation& turn) {
  return std::acos(std::clamp(1 - 2 * (turn.x * turn.x + turn.y * turn.y), -1.0, 1.0));
}

double yaw_of(const Orientation& turn) {
  return std::atan2(2 * (turn.x * turn.y + turn.w * turn.z),
                    1 - 2 * (turn.y * turn.y + turn.z * turn.z));
}

std::string tilted_by(double tilt) {
  return "which is tilted by " + rounded(wend::degrees_from(tilt)) + " degrees";
}

}  // namespace

bool is_unset(const Orientation& turn) {
  return turn.x == 0 && turn.y == 0 && turn.z == 0 && turn.w == 0;
}

wend::Expected<double, std::string> heading_of(const Orientation& turn) {
  const auto unit = normalised(turn);
  if (!unit) return wend::Unexpected<std::string>(unit.error());
  const double tilt = tilt_of(*unit);
  if (tilt > kLargestTilt) return fault(turn, tilted_by(tilt));
  return yaw_of(*unit);
}

wend::Expected<double, std::string> heading_of_frame(const Orientation& turn) {
  constexpr double kRamp = wend::radians_from(45);
  const auto unit = normalised(turn);
  if (!unit) return wend::Unexpected<std::string>(unit.error());
  const double tilt = tilt_of(*unit);
  if (tilt > kRamp && wend::kPi - tilt > kRamp) return fault(turn, tilted_by(tilt));
  return yaw_of(*unit);
}

}  // namespace wend_ros
