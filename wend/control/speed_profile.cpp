#include "wend/control/speed_profile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/path/speed_passes.hpp"
#include "wend/path/trajectory.hpp"

namespace wend {
namespace {

/// 1 / m
double curvature_at(const MapPolyline& line, double along, double window) {
  const double from = std::max(along - window, 0.0);
  const double to = std::min(along + window, line.length());
  if (from >= to) return 0;
  const double turn = line.heading_at(to, window) - line.heading_at(from, window);
  return normalized_angle(turn) / std::max(to - from, window);  // a short end is no tighter bend
}

/// In a bend, and where it changes by so much a metre.
double speed_in(double curvature, double change, const SpeedProfileOptions& options) {
  const double in_bend =
      fastest_on(curvature, {.speed = options.limits.speed,
                             .turn_rate = options.limits.turn_rate,
                             .lateral_acceleration = options.lateral_acceleration});
  const double while_steering = std::sqrt(options.limits.turn_acceleration / std::abs(change));
  return std::max(std::min(in_bend, while_steering), options.min_speed);
}

}  // namespace

void SpeedProfile::begin(const MapPolyline& line, const SpeedProfileOptions& options) {
  assert(options.window > 0);
  constexpr double kMostSamples = 1e5;
  min_speed_ = options.min_speed;
  const double wanted = std::ceil(2 * line.length() / options.window);
  const auto count = static_cast<std::size_t>(std::clamp(wanted, 1.0, kMostSamples)) + 1;
  step_ = line.length() / static_cast<double>(count - 1);
  squared_.assign(count, line.length() == 0 ? 0 : options.limits.speed * options.limits.speed);
  if (line.length() == 0) return;
  slow_in_bends(line, options);
  squared_.back() = 0;
  limit_braking(squared_, [&](std::size_t) { return 2 * options.limits.acceleration * step_; });
}

/// And the lookahead before them.
void SpeedProfile::slow_in_bends(const MapPolyline& line, const SpeedProfileOptions& options) {
  double curvature = curvature_at(line, 0, options.window);
  for (std::size_t i = 0; i < squared_.size(); ++i) {
    const double next = i + 1 < squared_.size()
                            ? curvature_at(line, step_ * static_cast<double>(i + 1), options.window)
                            : curvature;
    const double speed = speed_in(curvature, (next - curvature) / step_, options);
    const double ahead = options.lookahead + options.lookahead_time * speed;
    const auto before = static_cast<std::size_t>(std::min(ahead / step_, static_cast<double>(i)));
    for (std::size_t k = i - before; k <= i; ++k) {
      squared_[k] = std::min(squared_[k], speed * speed);
    }
    curvature = next;
  }
}

double SpeedProfile::at(double along) const {
  assert(!squared_.empty());
  const double place =
      step_ > 0 ? std::clamp(along / step_, 0.0, static_cast<double>(squared_.size() - 1)) : 0;
  const auto i = std::min(static_cast<std::size_t>(place), squared_.size() - 2);
  const double share = place - static_cast<double>(i);
  const double squared = squared_[i] + share * (squared_[i + 1] - squared_[i]);
  return std::max(std::sqrt(squared), min_speed_);
}

}  // namespace wend
