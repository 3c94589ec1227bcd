#pragma once

// GoalCosts: costs to the goals that know the obstacles, in a space that is smaller than that of the
// search: Dijkstra's algorithm from the goals, as far as it is asked for. D. Dolgov, S. Thrun et al., "Path
// Planning for Autonomous Vehicles in Unknown Semi-structured Environments", 2010, call this the holonomic
// heuristic with obstacles.
//
//   costs.begin(limits);
//   costs.add(costs.space().state(goal));
//   const auto estimate = costs(costs.space().state(vertex));

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/search/forward_search.hpp"

namespace wend {

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

template <class Space, class Frontier, class Links = StepLinks>
class GoalCosts {
 public:
  using State = typename Space::State;
  using Cost = typename Space::Cost;

  explicit GoalCosts(Space space) : search_(std::move(space), {}) {}

  bool allocated() const { return search_.allocated(); }
  const Space& space() const { return search_.space(); }

  /// Forgets the goals; keeps its memory.
  void begin(const Limits& limits) {
    limits_ = limits;
    limits_.expansions = Limits::kUnlimited;
    farthest_ = 0;
    goals_.clear();
    begun_ = false;
  }

  /// Not after the first question.
  void add(const State& goal) { goals_.push_back(goal); }

  /// As far as it came where no way leads, and where the search was stopped before it came to know:
  /// costs that are cut off at one value are still consistent.
  Cost operator()(const State& state) {
    // Begun when the search that asks has begun: so its time is not over before that one's.
    if (!begun_) search_.begin(goals_, limits_);
    begun_ = true;
    const StateId id = search_.space().id(state);
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
    using Key = typename Frontier::Key;

    Key key(const State& /*state*/, Cost g) const { return {g, g}; }
    bool is_goal(const State& /*state*/) const { return false; }
    bool near_overflow(const Key& key) const { return near_overflow_of(key); }
  };

  struct Odometer : NoObserver {
    Cost& farthest;

    void on_expand(const State& /*state*/, auto /*arrival*/, Cost g) const { farthest = g; }
  };

  ForwardSearch<Space, Frontier, ByCost, DuplicateRule::keep_cheaper, Links> search_;
  std::vector<State> goals_;
  Limits limits_;
  bool begun_ = false;
  Cost farthest_ = 0;  // g of the state expanded last
};

}  // namespace wend
