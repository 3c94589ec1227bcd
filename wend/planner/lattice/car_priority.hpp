#pragma once

// How a car's search orders poses: keys and frontiers (f, then the larger g; whole numbers go into
// buckets, real ones into a heap), costs around obstacles, and CarPriority.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/space/lattice/car_heuristic.hpp"
#include "wend/space/lattice/car_space.hpp"

namespace wend {

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

/// Keys grow by less than this between two looks, of 256 expansions.
template <class Cost>
bool near_overflow_of(const ExactKey<Cost>& key) {
  constexpr std::uint64_t kMargin = std::uint64_t{1} << 28U;
  return sizeof(Cost) == sizeof(std::uint32_t) && key.f() > UINT32_MAX - kMargin;
}
template <class Cost>
bool near_overflow_of(const RealKey<Cost>& /*key*/) {
  return false;
}

/// What it costs a car that turns on the spot to come from a corner to a goal. Dijkstra's
/// algorithm from the goals, as far as it is asked for: an estimate that knows the obstacles (D.
/// Dolgov, S. Thrun et al., "Path Planning for Autonomous Vehicles in Unknown Semi-structured
/// Environments", 2010, call it the holonomic one).
template <class Costs>
class CornerCosts {
 public:
  using Cost = typename Costs::Cost;

  explicit CornerCosts(CarSpace<Costs> car) : search_(CornerSpace<Costs>(std::move(car)), {}) {}

  bool allocated() const { return search_.allocated(); }

  void begin(std::span<const CarGoal> goals, const Limits& limits) {
    limits_ = limits;
    limits_.expansions = Limits::kUnlimited;
    farthest_ = 0;
    starts_.clear();
    for (const CarGoal& goal : goals) starts_.push_back(search_.space().state(goal.corner));
    begun_ = false;
  }

  /// As far as it came where no way leads, and where the search was stopped before it came to know:
  /// costs that are cut off at one value are still consistent.
  Cost operator()(Cell corner) {
    // Begun when the search that asks has begun: so its time is not over before that one's.
    if (!begun_) search_.begin(starts_, limits_);
    begun_ = true;
    const StateId id = search_.space().state(corner).number;
    while (!search_.closed(id)) {
      if (search_.outcome() != SearchOutcome::running) return farthest_;
      search_.step(Odometer{{}, farthest_});
    }
    return search_.g(id);
  }

  /// Was it stopped, so that its answers are worth nothing? By a limit, or for too large costs.
  std::optional<SearchOutcome> stopped() const {
    const SearchOutcome outcome = search_.outcome();
    if (!begun_ || outcome == SearchOutcome::running || outcome == SearchOutcome::exhausted) {
      return std::nullopt;
    }
    return outcome;
  }

 private:
  struct ByCost {
    using Key = CarKey<Cost>;

    Key key(const CornerState& /*state*/, Cost g) const { return {g, g}; }
    bool is_goal(const CornerState& /*state*/) const { return false; }
    bool near_overflow(const Key& key) const { return near_overflow_of(key); }
  };

  struct Odometer : NoObserver {
    Cost& farthest;

    void on_expand(const CornerState& /*state*/, Move /*arrival*/, Cost g) const { farthest = g; }
  };

  ForwardSearch<CornerSpace<Costs>, CarFrontier<Cost>, ByCost, DuplicateRule::keep_cheaper> search_;
  std::vector<CornerState> starts_;
  Limits limits_;
  bool begun_ = false;
  Cost farthest_ = 0;  // g of the corner expanded last
};

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
      around_obstacles_ = std::make_unique<CornerCosts<Costs>>(space);
    }
  }

  bool allocated() const { return around_obstacles_ == nullptr || around_obstacles_->allocated(); }

  /// At least one goal. Keeps its memory from query to query.
  void begin(std::span<const CarGoal> goals, const Limits& limits) {
    goals_.assign(goals.begin(), goals.end());
    if (around_obstacles_ != nullptr) around_obstacles_->begin(goals, limits);
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
                       [&](const CarGoal& goal) { return goal.contains(state.place); });
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
        return least([&](const CarGoal& goal) {
          return diagonal_estimate<Costs>(place.corner, goal.corner);
        });
      case CarHeuristic::headings:
        return on_empty_yard(place);
      case CarHeuristic::obstacles:
        return std::max(on_empty_yard(place), (*around_obstacles_)(place.corner));
    }
    return Cost{0};
  }

  Cost on_empty_yard(const CornerPose& place) const {
    return least([&](const CarGoal& goal) { return headings_estimate<Costs>(place, goal); });
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
  std::vector<CarGoal> goals_;
  std::unique_ptr<CornerCosts<Costs>> around_obstacles_;
};

}  // namespace wend
