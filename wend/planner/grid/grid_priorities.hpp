#pragma once

// Priorities of grid searches: the key by which a frontier orders a cell. Ties go to the larger g;
// the frontier then takes the newest.
//
// h and f are for those who watch, in cells.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>

#include "wend/base/limits.hpp"
#include "wend/planner/goal_cells.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/space/grid/grid_space.hpp"
#include "wend/space/grid/heuristic.hpp"

namespace wend {

/// What the priorities of grid searches share: they know the goals of the query, need no memory that
/// could be missing, and never stop a search.
class TowardsGoals {
 public:
  bool allocated() const { return true; }
  std::optional<SearchOutcome> stopped() const { return std::nullopt; }
  void begin(std::span<const GoalRegion> goals, const Limits& /*limits*/) { goals_.assign(goals); }

  bool is_goal(const GridState& state) const { return goals_.contains(state.cell); }

 protected:
  GoalCells goals_;
};

/// No order but that of arrival.
class ByArrival : public TowardsGoals {
 public:
  using Key = NoKey;

  Key key(const GridState& /*state*/, std::uint64_t /*g*/) const { return {}; }
  bool near_overflow(Key /*key*/) const { return false; }
  double h(Cell /*cell*/) const { return 0; }
  double f(Cell /*cell*/, double g) const { return g; }
};

/// That of arrival, and among ways of as few steps the shortest one.
class ByFewestSteps : public ByArrival {
 public:
  bool replaces(std::uint64_t g, std::uint64_t before) const {
    return g < before && steps_of_cost(g) == steps_of_cost(before);
  }
};

/// f, then the larger g, as one comparison of whole numbers.
template <class Cost>
class ExactKey;

template <>
class ExactKey<std::uint32_t> {
 public:
  ExactKey() = default;
  ExactKey(std::uint32_t f, std::uint32_t g) : packed_((std::uint64_t{f} << 32U) | ~g) {}
  std::uint64_t f() const { return packed_ >> 32U; }
  friend bool operator<(ExactKey a, ExactKey b) { return a.packed_ < b.packed_; }

 private:
  std::uint64_t packed_ = 0;
};

template <>
class ExactKey<std::uint64_t> {
 public:
  ExactKey() = default;
  ExactKey(std::uint64_t f, std::uint64_t g) : f_(f), g_(g) {}
  std::uint64_t f() const { return f_; }
  friend bool operator<(const ExactKey& a, const ExactKey& b) {
    return a.f_ != b.f_ ? a.f_ < b.f_ : a.g_ > b.g_;
  }

 private:
  std::uint64_t f_ = 0;
  std::uint64_t g_ = 0;
};

template <class Cost>
std::uint64_t f_of(const ExactKey<Cost>& key) {
  return key.f();
}

/// f = g + h in whole numbers, for the heuristics that are sums of straight and diagonal steps:
/// h = major * (the longer side) + minor * (the shorter side).
template <class Cost>
class ExactEstimate : public TowardsGoals {
 public:
  using Key = ExactKey<Cost>;

  /// `kind` is zero, constant, manhattan or octile. A constant changes no order and is only shown.
  ExactEstimate(HeuristicKind kind, double constant) : kind_(kind), constant_(constant) {
    if (kind == HeuristicKind::manhattan) major_ = minor_ = Units::kStraight;
    if (kind == HeuristicKind::octile) {
      major_ = Units::kStraight;
      minor_ = Units::kDiagonal - Units::kStraight;
    }
  }

  Key key(const GridState& state, Cost g) const {
    const Cost estimate = goals_.least(state.cell, [&](Cell goal) {
      const auto dx = static_cast<Cost>(std::abs(state.cell.x - goal.x));
      const auto dy = static_cast<Cost>(std::abs(state.cell.y - goal.y));
      return static_cast<Cost>(major_ * std::max(dx, dy) + minor_ * std::min(dx, dy));
    });
    return {static_cast<Cost>(g + estimate), g};
  }

  /// Keys grow by less than this between two looks (256 expansions of at most 2 sqrt(2) cells).
  bool near_overflow(Key key) const {
    constexpr std::uint64_t kMargin = std::uint64_t{1} << 26U;
    return sizeof(Cost) == sizeof(std::uint32_t) && key.f() > UINT32_MAX - kMargin;
  }

  double h(Cell cell) const {
    return goals_.least(cell,
                        [&](Cell goal) { return heuristic_value(kind_, constant_, cell, goal); });
  }
  double f(Cell cell, double g) const { return g + h(cell); }

 private:
  using Units = OctileUnits<Cost>;

  HeuristicKind kind_;
  double constant_;
  Cost major_ = 0;
  Cost minor_ = 0;
};

/// f, then the larger g, where f is a real number.
template <class Cost>
struct RealKey {
  double f = 0;
  Cost g = 0;

  friend bool operator<(const RealKey& a, const RealKey& b) {
    if (a.f < b.f) return true;
    return !(b.f < a.f) && a.g > b.g;
  }
};

template <class Cost>
double f_of(const RealKey<Cost>& key) {
  return key.f;
}

/// f = a g + w h: any heuristic and weight, and with a = 0 greedy search.
template <class Space>
class RealEstimate : public TowardsGoals {
 public:
  using Cost = typename Space::Cost;
  using Key = RealKey<Cost>;

  /// A constant changes no order and is only shown: added to a key, a large one would cost digits.
  RealEstimate(HeuristicKind kind, double constant, double g_share, double weight)
      : kind_(kind),
        constant_(constant),
        g_share_(g_share),
        weight_(weight),
        weight_in_key_(
            kind == HeuristicKind::constant ? 0 : weight * kNotAbove * Space::kUnitsPerCell) {}

  Key key(const GridState& state, Cost g) const {
    return {g_share_ * static_cast<double>(g) + weight_in_key_ * h(state.cell), g};
  }

  bool near_overflow(const Key& /*key*/) const { return false; }

  double h(Cell cell) const {
    return goals_.least(cell,
                        [&](Cell goal) { return heuristic_value(kind_, constant_, cell, goal); });
  }
  double f(Cell cell, double g) const { return g_share_ * g + weight_ * h(cell); }

 private:
  // sqrt(2) is rounded: a hair less keeps an exact estimate from rounding above the true cost.
  static constexpr double kNotAbove = 1 - 1e-12;

  HeuristicKind kind_;
  double constant_;
  double g_share_;
  double weight_;
  double weight_in_key_;
};

}  // namespace wend
