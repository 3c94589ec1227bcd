#pragma once

// TurningCost: what a robot pays at least for facing another way than where it has to go: the difference between the
// cheapest connection to a far point and the line to it. A table over the cosine of the angle.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "wend/space/se2/steering.hpp"

namespace wend {

class TurningCost {
 public:
  explicit TurningCost(const Steering& steering) {
    const double far = std::max(1.0, kFar * steering.radius());
    std::array<Connection, 1> best;
    for (std::size_t i = 0; i < kSteps; ++i) {
      const double cosine = std::clamp(2.0 * static_cast<double>(i) / (kSteps - 1) - 1, -1.0, 1.0);
      const double angle = arc_tangent(std::sqrt(1 - cosine * cosine), cosine);
      double least = Connection{}.cost;
      std::array<double, 4> headings{};
      const Pose from{0, 0, angle};
      const int count = steering.arrivals(from, {far, 0}, headings);
      for (int k = 0; k < count; ++k) {
        const Pose to{far, 0, headings[static_cast<std::size_t>(k)]};
        if (steering.connect(from, to, 0, least, best) > 0) least = best[0].cost;
      }
      table_[i] = std::isfinite(least) ? std::max(0.0, least - far) : 0;
    }
  }

  /// For the cosine of the angle between heading and way, in cells.
  double operator()(double cosine) const {
    const double place = (std::clamp(cosine, -1.0, 1.0) + 1) / 2 * (kSteps - 1);
    const auto low = std::min(static_cast<std::size_t>(place), kSteps - 2);
    const double share = place - static_cast<double>(low);
    return table_[low] * (1 - share) + table_[low + 1] * share;
  }

 private:
  static constexpr std::size_t kSteps = 64;
  static constexpr double kFar = 20;  // turning radii

  std::array<double, kSteps> table_{};
};

}  // namespace wend
