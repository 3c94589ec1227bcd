#pragma once

#include <cassert>
#include <vector>

#include "wend/path/smoothing/gradient_smoother.hpp"

namespace wend {

/// What smooth_by_gradient() minimises: of a path and what it became, with as many points.
inline double smoothing_objective(const Path& path, const Path& smoothed,
                                  const GradientOptions& options) {
  const std::vector<Point> from = path.points();
  const std::vector<Point> to = smoothed.points();
  assert(from.size() == to.size());
  const auto squared = [](Point a, Point b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
  };
  double held = 0;
  double drawn = 0;
  for (std::size_t i = 1; i < from.size(); ++i) {
    held += squared(from[i], to[i]);
    drawn += squared(to[i - 1], to[i]);
  }
  return options.alpha * held + options.beta * drawn;
}

}  // namespace wend
