// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"

namespace wend_nav2 {
namespace {

constexpr double kMostOfLength = 0.1;  // by which a squared length may differ from 1
constexpr double kNoLength = 1e-6;     // squared

double degrees_of(Tilt tilt) { return tilt == Tilt::flat ? 2.5 : 45; }

/// Of the z axis from the vertical, in degrees; of a rotation of any length but 0.
double lean_of(const Quaternion& q, double squared_length) {
  const double cosine = (q.w * q.w + q.z * q.z - q.x * q.x - q.y * q.y) / squared_length;
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / wend::kPi;
}

std::string text_of(const Quaternion& q) {
  return "its orientation (x " + wend::format_number(q.x) + ", y " + wend::format_number(q.y) +
         ", z " + wend::format_number(q.z) + ", w " + wend::format_number(q.w) + ") ";
}

std::string rounded(double value) { return wend::format_number(std::round(value * 1000) / 1000); }

}  // namespace

wend::Expected<double, std::string> heading_of(const Quaternion& q, Tilt tilt) {
  const auto refused = [&](std::string reason) {
    return wend::Unexpected<std::string>(text_of(q) + std::move(reason));
  };
  const double squared = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!std::isfinite(squared)) return refused("contains NaN or infinity, or is far too long");
  if (squared < kNoLength) return refused("has the length 0: without a rotation, w is 1");
  if (std::abs(squared - 1) > kMostOfLength) {
    return refused("has the length " + rounded(std::sqrt(squared)) +
                   ", not 1: a heading h is z = sin(h / 2), w = cos(h / 2)");
  }
  if (const double lean = lean_of(q, squared); lean > degrees_of(tilt)) {
    return refused("leans " + rounded(lean) + " degrees from the vertical, at most " +
                   wend::format_number(degrees_of(tilt)) +
                   " expected: a heading is a turn about z, with x = y = 0");
  }
  return std::atan2(2 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z);
}

}  // namespace wend_nav2
