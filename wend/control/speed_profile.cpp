#include "wend/control/speed_profile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

/// 1 / m, at so many places `step` apart.
std::vector<double> curvatures_of(const Polyline& line, double window, double step,
                                  std::size_t count) {
  std::vector<double> curvatures(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double along = step * static_cast<double>(i);
    const double from = std::max(along - window, 0.0);
    const double to = std::min(along + window, line.length());
    if (from >= to) continue;
    const double turn = line.heading_at(to, window) - line.heading_at(from, window);
    curvatures[i] = normalized_angle(turn) / (to - from);
  }
  return curvatures;
}

/// In a bend, and where it changes by so much a metre.
double speed_in(double curvature, double change, const SpeedProfileOptions& options) {
  const double bend = std::abs(curvature);
  const double fastest = std::min({options.limits.speed, options.limits.turn_rate / bend,
                                   std::sqrt(options.lateral_acceleration / bend),
                                   std::sqrt(options.limits.turn_acceleration / std::abs(change))});
  return std::max(fastest, options.least_speed);
}

}  // namespace

SpeedProfile::SpeedProfile(const Polyline& line, const SpeedProfileOptions& options)
    : least_speed_(options.least_speed) {
  assert(options.window > 0);
  constexpr double kMostSamples = 1e5;
  const double wanted = std::ceil(2 * line.length() / options.window);
  const auto count = static_cast<std::size_t>(std::clamp(wanted, 1.0, kMostSamples)) + 1;
  step_ = line.length() / static_cast<double>(count - 1);
  squared_.assign(count, line.length() == 0 ? 0 : options.limits.speed * options.limits.speed);
  if (line.length() == 0) return;
  const std::vector<double> curvatures = curvatures_of(line, options.window, step_, count);
  for (std::size_t i = 0; i < count; ++i) {
    const double change = i + 1 < count ? (curvatures[i + 1] - curvatures[i]) / step_ : 0;
    const double speed = speed_in(curvatures[i], change, options);
    const double ahead = options.lookahead + options.lookahead_time * speed;
    const auto before = static_cast<std::size_t>(std::min(ahead / step_, static_cast<double>(i)));
    for (std::size_t k = i - before; k <= i; ++k)
      squared_[k] = std::min(squared_[k], speed * speed);
  }
  squared_.back() = 0;
  for (std::size_t i = count - 1; i-- > 0;) {
    squared_[i] = std::min(squared_[i], squared_[i + 1] + 2 * options.limits.acceleration * step_);
  }
}

double SpeedProfile::at(double along) const {
  const double place =
      step_ > 0 ? std::clamp(along / step_, 0.0, static_cast<double>(squared_.size() - 1)) : 0;
  const auto i = std::min(static_cast<std::size_t>(place), squared_.size() - 2);
  const double share = place - static_cast<double>(i);
  const double squared = squared_[i] + share * (squared_[i + 1] - squared_[i]);
  return std::max(std::sqrt(squared), least_speed_);
}

}  // namespace wend
