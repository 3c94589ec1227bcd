#pragma once

// How a car's search orders poses: keys and frontiers (f, then the larger g; whole numbers go into
// buckets, real ones into a heap), and CarPriority.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/planner/lattice/goal_costs.hpp"
#include "wend/planner/lattice/lattice_options.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/space/lattice/car_heuristic.hpp"
#include "wend/space/lattice/car_space.hpp"

namespace wend {

/// Where a car's path may end.
struct CarRegion {
  GoalRegion corners;
  std::optional<Heading> heading{};  // the nearest to that of the goal; none: any is accepted
  unsigned headings = kAnyHeading;   // those accepted, as bits

  static constexpr unsigned kAnyHeading = (1U << kHeadings) - 1;

  bool accepts(Heading faced) const {
    return ((headings >> static_cast<unsigned>(faced)) & 1U) != 0;
  }
  bool contains(const CornerPose& place) const {
    return accepts(place.heading) && corners.contains(place.corner);
  }
};

template <class Cost>
using CarKey = std::conditional_t<std::is_integral_v<Cost>, ExactKey<Cost>, RealKey<Cost>>;

/// A move raises f by at most twice its cost, at most 10 turns: the ring's 256 buckets hold that.
inline constexpr unsigned kCarBucketBits = 12;
static_assert(2 * static_cast<std::uint64_t>(kMostWholeMultiplier) * CarUnits::kTurn <
              (std::uint64_t{256} << kCarBucketBits));

template <class Cost>
using CarFrontier =
    std::conditional_t<std::is_integral_v<Cost>, BucketFrontier<CarKey<Cost>, kCarBucketBits>,
                       HeapFrontier<CarKey<Cost>>>;

/// What it costs a car that turns on the spot to come from a corner to a goal.
template <class Costs>
using CornerCosts = GoalCosts<CornerSpace<Costs>, CarFrontier<typename Costs::Cost>>;

/// f = g + w h for a car, with any of its heuristics. In whole numbers w is 1 (or h is zero). h and
/// f are for observers, in units.
template <class Costs>
class CarPriority {
 public:
  using Cost = typename Costs::Cost;
  using Key = CarKey<Cost>;

  CarPriority(const CarSpace<Costs>& space, CarHeuristic kind, double weight)
      : kind_(kind),
        scale_(std::min(1.0, space.lattice().driving().reverse_factor)),
        weight_(weight) {
    if (kind == CarHeuristic::obstacles) {
      around_obstacles_ = std::make_unique<CornerCosts<Costs>>(CornerSpace<Costs>(space));
    }
  }

  bool allocated() const { return around_obstacles_ == nullptr || around_obstacles_->allocated(); }

  /// At least one goal. Keeps its memory from query to query.
  void begin(std::span<const CarRegion> goals, const Limits& limits) {
    goals_.assign(goals.begin(), goals.end());
    if (around_obstacles_ == nullptr) return;
    around_obstacles_->begin(limits);
    for (const CarRegion& goal : goals) {
      goal.corners.for_each(
          [&](Cell corner) { around_obstacles_->add(around_obstacles_->space().state(corner)); });
    }
  }

  /// Could the estimates not be made to the end?
  std::optional<SearchOutcome> stopped() const {
    return around_obstacles_ == nullptr ? std::nullopt : around_obstacles_->stopped();
  }

  Key key(const CarState& state, Cost g) const {
    const Cost estimate = estimate_of(state.place);
    if constexpr (std::is_integral_v<Cost>) {
      return {static_cast<Cost>(g + estimate), g};
    } else {
      return {g + weight_ * scale_ * kNotAbove * estimate, g};
    }
  }

  bool is_goal(const CarState& state) const {
    return std::any_of(goals_.begin(), goals_.end(),
                       [&](const CarRegion& goal) { return goal.contains(state.place); });
  }

  /// Without good estimates there is no use in going on: the engine asks why they stopped().
  bool near_overflow(const Key& key) const { return near_overflow_of(key) || stopped(); }

  double h(const CornerPose& place) const {
    if (goals_.empty()) return 0;
    return scale_ * static_cast<double>(estimate_of(place)) / Costs::kUnitsPerCell;
  }
  double f(const CornerPose& place, double g) const { return g + weight_ * h(place); }

 private:
  // pi / 2 is rounded: a hair less keeps an exact estimate from rounding above the true cost.
  static constexpr double kNotAbove = 1 - 1e-12;

  Cost estimate_of(const CornerPose& place) const {
    switch (kind_) {
      case CarHeuristic::zero:
        break;
      case CarHeuristic::diagonal:
        return least([&](const CarRegion& goal) { return diagonal(place, goal); });
      case CarHeuristic::headings:
        return on_empty_yard(place);
      case CarHeuristic::obstacles:
        return std::max(on_empty_yard(place),
                        (*around_obstacles_)(around_obstacles_->space().state(place.corner)));
    }
    return Cost{0};
  }

  Cost on_empty_yard(const CornerPose& place) const {
    return least([&](const CarRegion& goal) {
      return goal.corners.is_one_place() ? to_corner(place, goal) : diagonal(place, goal);
    });
  }

  static Cost diagonal(const CornerPose& place, const CarRegion& goal) {
    return diagonal_estimate<Costs>(place.corner, goal.corners.nearest_in_box(place.corner));
  }

  /// The estimate to a goal of one corner.
  static Cost to_corner(const CornerPose& place, const CarRegion& goal) {
    const Cell corner = goal.corners.any();
    if (goal.headings == CarRegion::kAnyHeading) {
      return headings_estimate<Costs>(place, CarGoal{corner, std::nullopt});
    }
    Cost least = headings_estimate<Costs>(place, CarGoal{corner, goal.heading});
    for (const Heading heading : kAllHeadings) {
      if (!goal.accepts(heading) || heading == goal.heading) continue;
      least = std::min(least, headings_estimate<Costs>(place, CarGoal{corner, heading}));
    }
    return least;
  }

  template <class Estimate>
  Cost least(Estimate&& estimate) const {
    Cost least = estimate(goals_.front());
    for (std::size_t i = 1; i < goals_.size(); ++i) least = std::min(least, estimate(goals_[i]));
    return least;
  }

  CarHeuristic kind_;
  double scale_;  // where reversing costs less than driving ahead
  double weight_;
  std::vector<CarRegion> goals_;
  std::unique_ptr<CornerCosts<Costs>> around_obstacles_;
};

}  // namespace wend
