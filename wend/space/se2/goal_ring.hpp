#pragma once

// GoalRing: what it costs at least to arrive at a goal with its heading, from poses near it where nothing is in the
// way. A table in the goal's frame, made where it is asked for; it does not depend on the map.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/space/se2/steering.hpp"

namespace wend {

class GoalRing {
 public:
  static constexpr double kReach = 4;  // turning radii: the table is used so far from the goal

  /// The steering must outlive the ring. Places are computed when they are first asked for: all of them take
  /// milliseconds.
  explicit GoalRing(const Steering& steering) : steering_(steering), unit_(steering.radius() / 2) {
    if (unit_ == 0) return;
    costs_.resize(std::size_t{kColumns} * kRows * kStride, kNotComputed);
  }

  /// How far from a goal it is used, in cells; 0 for robots that turn in place.
  double reach() const { return 2 * kReach * unit_; }

  /// The cost from a pose no farther than reach() to a goal, interpolated, in cells.
  double cost(const Pose& pose, const Pose& goal) {
    const Place place(pose, goal, unit_);
    const double turn = place.heading / kHeadingStep;
    const double low = std::floor(turn);
    const double share = turn - low;
    const auto first = static_cast<std::size_t>(static_cast<int>(low) + 2 * kHeadings) % kHeadings;
    const std::size_t second = (first + 1) % kHeadings;
    return interpolated(place, [&](const float* costs) {
      return costs[first] * (1 - share) + costs[second] * share;
    });
  }

  /// The least of these over all headings.
  double least_cost(Point point, const Pose& goal) {
    return interpolated(Place({point.x, point.y, goal.heading}, goal, unit_),
                        [](const float* costs) { return double{costs[kHeadings]}; });
  }

 private:
  static constexpr int kHalf = 10;  // columns to each side, as many as rows
  static constexpr int kColumns = 2 * kHalf + 1;
  static constexpr int kRows = kHalf + 1;  // the other side is the mirror image
  static constexpr std::size_t kHeadings = 24;
  static constexpr std::size_t kStride = kHeadings + 1;  // the last one is the least
  static constexpr double kHeadingStep = 2 * kPi / kHeadings;
  static constexpr float kNotComputed = -1;

  /// A pose in the goal's frame, in units, with y at least 0.
  struct Place {
    double x;
    double y;
    double heading;

    Place(const Pose& pose, const Pose& goal, double unit)
        : heading(wrapped_angle(pose.heading - goal.heading)) {
      const auto [sine, cosine] = sine_and_cosine(goal.heading);
      const double dx = (pose.x - goal.x) / unit;
      const double dy = (pose.y - goal.y) / unit;
      x = cosine * dx + sine * dy;
      y = cosine * dy - sine * dx;
      if (y < 0) {
        y = -y;
        heading = -heading;
      }
    }
  };

  /// The costs by heading, then the least of them.
  const float* costs_at(int column, int row) {
    float* const costs =
        costs_.data() + static_cast<std::size_t>(row * kColumns + column) * kStride;
    if (costs[kHeadings] == kNotComputed) compute(column, row, costs);
    return costs;
  }

  void compute(int column, int row, float* costs) const {
    costs[kHeadings] = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < kHeadings; ++i) {
      const double heading = wrapped_angle(static_cast<double>(i) * kHeadingStep);
      std::array<Connection, 1> best;
      const Pose from{(column - kHalf) * unit_, row * unit_, heading};
      const int count = steering_.connect(from, {0, 0, 0}, 0, best[0].cost, best);
      costs[i] = count > 0 ? static_cast<float>(best[0].cost) : 0;
      costs[kHeadings] = std::min(costs[kHeadings], costs[i]);
    }
  }

  template <class CostAt>
  double interpolated(const Place& place, CostAt&& cost_at) {
    const double x = std::clamp(place.x + kHalf, 0.0, kColumns - 1.0);
    const double y = std::clamp(place.y, 0.0, kRows - 1.0);
    const int column = std::min(static_cast<int>(x), kColumns - 2);
    const int row = std::min(static_cast<int>(y), kRows - 2);
    const double right = x - column;
    const double up = y - row;
    const auto at = [&](int dx, int dy) { return cost_at(costs_at(column + dx, row + dy)); };
    return (1 - up) * ((1 - right) * at(0, 0) + right * at(1, 0)) +
           up * ((1 - right) * at(0, 1) + right * at(1, 1));
  }

  const Steering& steering_;
  double unit_;  // cells between two columns
  std::vector<float> costs_;
};

}  // namespace wend
