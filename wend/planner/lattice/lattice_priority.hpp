#pragma once

// LatticePriority: f = g + w h on a lattice; of equal f, the larger g. Keys of whole costs are whole numbers, for
// which w is 1 or h is 0.
//
// Estimates say what h is; all are consistent. They have the types Place, Cost and AroundObstacles (GoalCosts in
// the space of the lattice's vertices), and these functions:
//
//   costs_around_obstacles()     searches of the way around the obstacles; null if they do not need it
//   operator()(place, goals, h)  the estimate for at least one goal; h(vertex) asks that search
//   scale()                      a factor on all estimates

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/planner/lattice/goal_costs.hpp"
#include "wend/planner/lattice/lattice_engine.hpp"
#include "wend/space/lattice/lattice_pose.hpp"

namespace wend {

template <class Cost>
using LatticeKey = std::conditional_t<std::is_integral_v<Cost>, ExactKey<Cost>, RealKey<Cost>>;

/// h and f are for observers, in units.
template <class Space, class Estimates>
class LatticePriority {
 public:
  using Place = typename Space::Place;
  using State = typename Space::State;
  using Cost = typename Space::Cost;
  using Goal = LatticeGoal<Place>;
  using Key = LatticeKey<Cost>;

  LatticePriority(Estimates estimates, double weight)
      : estimates_(std::move(estimates)),
        weight_(weight),
        around_obstacles_(estimates_.costs_around_obstacles()) {}

  bool allocated() const { return around_obstacles_ == nullptr || around_obstacles_->allocated(); }

  /// At least one goal. Keeps its memory from query to query.
  void begin(std::span<const Goal> goals, const Limits& limits) {
    goals_.assign(goals.begin(), goals.end());
    if (around_obstacles_ == nullptr) return;
    around_obstacles_->begin(limits);
    for (const Goal& goal : goals) {
      goal.vertices.for_each(
          [&](Cell vertex) { around_obstacles_->add(around_obstacles_->space().state(vertex)); });
    }
  }

  /// Could the estimates not be made to the end?
  std::optional<SearchOutcome> stopped() const {
    return around_obstacles_ == nullptr ? std::nullopt : around_obstacles_->stopped();
  }

  /// For a search in rounds, in real numbers: the weight of the next one.
  void weigh(double weight) { weight_ = weight; }
  /// For the same: at most the cost of a path through the state.
  Cost total(const State& state, Cost g) const
    requires(!std::is_integral_v<Cost>)
  {
    return g + estimates_.scale() * kNotAbove * estimate_of(state.place);
  }

  Key key(const State& state, Cost g) const {
    const Cost estimate = estimate_of(state.place);
    if constexpr (std::is_integral_v<Cost>) {
      return {static_cast<Cost>(g + estimate), g};
    } else {
      return {g + weight_ * estimates_.scale() * kNotAbove * estimate, g};
    }
  }

  bool is_goal(const State& state) const {
    return std::any_of(goals_.begin(), goals_.end(),
                       [&](const Goal& goal) { return goal.contains(state.place); });
  }

  /// A search without valid estimates stops; the engine asks stopped() why.
  bool near_overflow(const Key& key) const { return near_overflow_of(key) || stopped(); }

  double h(const Place& place) const {
    if (goals_.empty()) return 0;
    return estimates_.scale() * static_cast<double>(estimate_of(place)) / Space::kUnitsPerCell;
  }
  double f(const Place& place, double g) const { return g + weight_ * h(place); }

 private:
  // Sums are rounded: a hair less keeps an exact estimate from rounding above the true cost.
  static constexpr double kNotAbove = 1 - 1e-12;

  Cost estimate_of(const Place& place) const {
    return estimates_(place, std::span<const Goal>(goals_), [this](Cell vertex) {
      return (*around_obstacles_)(around_obstacles_->space().state(vertex));
    });
  }

  Estimates estimates_;
  double weight_;
  std::vector<Goal> goals_;
  std::unique_ptr<typename Estimates::AroundObstacles> around_obstacles_;
};

/// The least estimate(goal) over all goals; there is at least one.
template <class Goal, class Estimate>
auto least_over(std::span<const Goal> goals, Estimate&& estimate) {
  auto least = estimate(goals.front());
  for (std::size_t i = 1; i < goals.size(); ++i) least = std::min(least, estimate(goals[i]));
  return least;
}

}  // namespace wend
