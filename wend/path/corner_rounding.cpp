#include "wend/path/corner_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wend {
namespace {

/// 1 / cos - 1 of an angle, by its tangent: without rounding where that is small.
double secant_less_one(double tangent) {
  return tangent * tangent / (std::sqrt(1 + tangent * tangent) + 1);
}

double half_turn_tangent(Point from, Point at, Point to, double lengths) {
  const double cross = (at.x - from.x) * (to.y - at.y) - (at.y - from.y) * (to.x - at.x);
  const double dot = (at.x - from.x) * (to.x - at.x) + (at.y - from.y) * (to.y - at.y);
  if (cross == 0) return dot > 0 ? 0 : std::numeric_limits<double>::infinity();
  // tan(t / 2) = sin t / (1 + cos t), or (1 - cos t) / sin t where that is the exact one.
  const double sine = std::abs(cross);
  return dot > 0 ? sine / (lengths + dot) : (lengths - dot) / sine;
}

}  // namespace

Corner::Corner(Point from, Point at, Point to) {
  const double before = distance(from, at);
  const double after = distance(at, to);
  half_turn_ = wend::half_turn_tangent(from, at, to, before * after);
  constexpr double kStraight = 1e-9;
  if (half_turn_ < kStraight) half_turn_ = 0;
  tangent_ = std::min(before, after) / 2;
}

double Corner::radius(double window) const {
  if (half_turn_ == 0) return std::numeric_limits<double>::infinity();
  if (std::isinf(half_turn_)) return 0;
  return std::min(tangent_ / half_turn_, window / secant_less_one(half_turn_));
}

double Corner::widest_half_turn(double radius, double window) const {
  const double secant = 1 + window / radius;
  return std::min(tangent_ / radius, std::sqrt(secant * secant - 1));
}

}  // namespace wend
