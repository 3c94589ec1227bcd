#pragma once

// CornerCosts: what it costs a car that turns on the spot to come from a corner to a goal. Dijkstra's
// algorithm from the goals, as far as it is asked for: an estimate that knows the obstacles (D.
// Dolgov, S. Thrun et al., "Path Planning for Autonomous Vehicles in Unknown Semi-structured
// Environments", 2010, call it the holonomic one).

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/planner/lattice/car_keys.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/space/lattice/car_heuristic.hpp"
#include "wend/space/lattice/corner_space.hpp"

namespace wend {

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

}  // namespace wend
