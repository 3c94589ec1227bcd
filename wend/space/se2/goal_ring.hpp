#pragma once

// GoalRing: what it costs at least to arrive at a goal with its heading, from poses near it where nothing is in the
// way. A table in the goal's frame, made where it is asked for; it does not depend on the map.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/space/se2/steering.hpp"

namespace wend {

class GoalRing {
 public:
  static constexpr double kReach = 4;  // turning radii: the table is used so far from the goal

  /// Places are computed when they are first asked for: all of them take
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
    return interpolated(place, [&](int column, int row) {
      return heading_cost(column, row, first) * (1 - share) +
             heading_cost(column, row, second) * share;
    });
  }

  /// The least of these over all headings.
  double least_cost(Point point, const Pose& goal) {
    return interpolated(Place({point.x, point.y, goal.heading}, goal, unit_),
                        [&](int column, int row) { return least_at(column, row); });
  }

 private:
  static constexpr int kHalf = 10;  // columns to each side, as many as rows
  static constexpr int kColumns = 2 * kHalf + 1;
  static constexpr int kRows = kHalf + 1;  // the other side is the mirror image
  static constexpr std::size_t kHeadings = 24;
  static constexpr std::size_t kStride = kHeadings + 1;  // the last one is the least
  static constexpr double kHeadingStep = 2 * kPi / kHeadings;
  static constexpr float kNotComputed = -1;
  static constexpr double kAnyCost = std::numeric_limits<double>::infinity();

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
  float* costs_at(int column, int row) {
    return costs_.data() + static_cast<std::size_t>(row * kColumns + column) * kStride;
  }

  double heading_cost(int column, int row, std::size_t heading) {
    float& cost = costs_at(column, row)[heading];
    if (cost == kNotComputed) cost = computed(column, row, heading, kAnyCost).value_or(0.0F);
    return cost;
  }

  /// What costs no less than the least of the headings before is not computed to its end. The heading towards the goal
  /// comes first: it is cheap.
  double least_at(int column, int row) {
    float* const costs = costs_at(column, row);
    float& least = costs[kHeadings];
    if (least != kNotComputed) return least;
    const double towards = arc_tangent(-row, kHalf - column) / kHeadingStep;
    const auto first = static_cast<std::size_t>(std::floor(towards) + kHeadings);
    least = computed(column, row, first % kHeadings, kAnyCost).value_or(0.0F);
    for (std::size_t i = 1; i < kHeadings; ++i) {
      const std::size_t aside = i % 2 == 0 ? kHeadings - i / 2 : (i + 1) / 2;
      const auto cost = computed(column, row, (first + aside) % kHeadings, least);
      least = std::min(least, cost.value_or(least));
    }
    return least;
  }

  /// Nothing if it is not below `bound`.
  std::optional<float> computed(int column, int row, std::size_t heading, double bound) const {
    std::array<Connection, 1> best;
    const Pose from{(column - kHalf) * unit_, row * unit_,
                    wrapped_angle(static_cast<double>(heading) * kHeadingStep)};
    if (steering_.connect(from, {0, 0, 0}, 0, bound, best) == 0) return std::nullopt;
    return static_cast<float>(best[0].cost);
  }

  template <class CostAt>
  double interpolated(const Place& place, CostAt&& cost_at) {
    const double x = std::clamp(place.x + kHalf, 0.0, kColumns - 1.0);
    const double y = std::clamp(place.y, 0.0, kRows - 1.0);
    const int column = std::min(static_cast<int>(x), kColumns - 2);
    const int row = std::min(static_cast<int>(y), kRows - 2);
    const double right = x - column;
    const double up = y - row;
    const auto at = [&](int dx, int dy) { return cost_at(column + dx, row + dy); };
    return (1 - up) * ((1 - right) * at(0, 0) + right * at(1, 0)) +
           up * ((1 - right) * at(0, 1) + right * at(1, 1));
  }

  Steering steering_;
  double unit_;  // cells between two columns
  std::vector<float> costs_;
};

}  // namespace wend
