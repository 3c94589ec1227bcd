#pragma once

// Sine, cosine, tangent, arc tangent and hypotenuse, the same on every platform: mathematical libraries differ in the last bits, and
// these functions use nothing but + - * / and comparisons. (Where a compiler may fuse a multiplication and an
// addition by itself, it has to be told not to: -ffp-contract=off.)
//
//   const wend::SineCosine north = wend::sine_and_cosine(wend::kPi / 2);
//   const double heading = wend::arc_tangent(1, -1);  // 3/4 pi
//
// Errors: at most 3e-16 absolutely for sine and cosine of angles up to 1e6, at most 3 units in the last place
// for the arc tangent. Without branches that depend on the quadrant: a few nanoseconds each.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "wend/geometry/angle.hpp"

namespace wend {

/// The sine and the cosine of one angle.
struct SineCosine {
  double sine = 0;    // in [-1, 1]
  double cosine = 1;  // in [-1, 1]
};

/// The sine and the cosine of a finite angle in radians; NaN for other numbers. From 1e6 on, the error grows:
/// it is about 4e-17 times the angle.
inline SineCosine sine_and_cosine(double radians) {
  constexpr double kMostReduced = 1e6;
  if (!(std::abs(radians) < kMostReduced)) radians = std::remainder(radians, 2 * kPi);
  // Adding this number rounds to an integer, which the lowest bits of the sum then hold.
  constexpr double kRounding = 6755399441055744.0;  // 1.5 * 2^52
  constexpr double kQuartersPerRadian = 0.6366197723675814;
  const double quarters = (radians * kQuartersPerRadian + kRounding) - kRounding;
  // pi / 2 in three parts. The first two have 33 bits, so that their products are exact.
  constexpr std::array<double, 3> kQuarter{1.5707963267341256, 6.077100506303966e-11,
                                           2.0222662487959506e-21};
  const double rest = ((radians - quarters * kQuarter[0]) - quarters * kQuarter[1]) -
                      quarters * kQuarter[2];  // in [-pi/4, pi/4]
  const double w = rest * rest;
  // Polynomials with the least largest error on [-pi/4, pi/4], below 2e-17.
  const double sine =
      rest + rest * w *
                 ((-0.16666666666666666 + w * 0.008333333333330948) +
                  w * w *
                      ((-0.00019841269836758574 + w * 2.755731610255242e-06) +
                       w * w * (-2.505113184499973e-08 + w * 1.5918129294585977e-10)));
  const double cosine =
      (1 - w / 2) + w * w *
                        ((0.041666666666666664 + w * -0.0013888888888887398) +
                         w * w *
                             ((2.480158729876569e-05 + w * -2.755731727172978e-07) +
                              w * w * (2.0876146268400763e-09 + w * -1.1382632425346156e-11)));
  // Not std::round(), which is a call on some platforms. NaN has no integer.
  const auto quadrant =
      static_cast<std::uint64_t>(static_cast<std::int64_t>(quarters == quarters ? quarters : 0.0));
  const std::array<double, 2> both{sine, cosine};
  const std::size_t swapped = quadrant & 1U;
  constexpr std::array<double, 2> kSign{1, -1};
  return {both[swapped] * kSign[(quadrant >> 1U) & 1U],
          both[1 - swapped] * kSign[((quadrant + 1) >> 1U) & 1U]};
}

/// The tangent of a finite angle in radians.
inline double tangent(double radians) {
  const SineCosine both = sine_and_cosine(radians);
  return both.sine / both.cosine;
}

/// sqrt(x x + y y), for numbers whose squares are neither too large nor too small for a double.
inline double hypotenuse(double x, double y) { return std::sqrt(x * x + y * y); }

/// The angle from +x to the point (x, y), in (-pi, pi]; 0 for the origin. Signs of zeros do not count. Both
/// coordinates are finite, and their ratio is neither too large nor too small for a double.
inline double arc_tangent(double y, double x) {
  const double along = std::max(std::abs(x), std::abs(y));
  const double across = std::min(std::abs(x), std::abs(y));
  if (along == 0) return 0;
  // The nearest of the angles 0, pi/8 and pi/4; what remains is at most pi/16.
  const auto eighths = static_cast<std::size_t>(across > 0.198912367379658 * along) +
                       static_cast<std::size_t>(across > 0.6681786379192989 * along);
  constexpr std::array<double, 3> kTangent{0, 0.41421356237309503, 1};
  const double z = (across - kTangent[eighths] * along) / (along + kTangent[eighths] * across);
  const double w = z * z;
  // The polynomial with the least largest error on [-tan(pi/16), tan(pi/16)], below 1e-18.
  const double rest = z * w *
                      (((-0.3333333333333333 + w * 0.1999999999999729) +
                        w * w * (-0.1428571428427355 + w * 0.11111110818998074)) +
                       (w * w) * (w * w) *
                           ((-0.09090879951934436 + w * 0.07690724472459606) +
                            w * w * (-0.06618732486585441 + w * 0.051157459665722646)));
  constexpr std::array<double, 3> kAngle{0, kPi / 8, kPi / 4};
  const double angle = kAngle[eighths] + (z + rest);
  // From the eighth of a turn to the right one: begin + sign * angle.
  constexpr std::array<double, 8> kBegin{0, 0, kPi, -kPi, kPi / 2, -kPi / 2, kPi / 2, -kPi / 2};
  constexpr std::array<double, 8> kSign{1, -1, -1, 1, -1, 1, 1, -1};
  const std::size_t octant = static_cast<std::size_t>(std::abs(y) > std::abs(x)) * 4 +
                             static_cast<std::size_t>(x < 0) * 2 + static_cast<std::size_t>(y < 0);
  return kBegin[octant] + kSign[octant] * angle;
}

}  // namespace wend
