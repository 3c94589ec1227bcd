#pragma once

// LatticePriority: f = g + w h on a lattice of motion primitives; of equal f, the larger g. Heuristics:
//
//   zero       0
//   distance   the straight distance, times the least that a step costs for each cell it leads
//   obstacles  the cheapest way around the obstacles for a robot that may take any heading at every vertex
//              (GoalCosts in VertexSpace; searched anew for every query)
//
// All are consistent.

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/planner/lattice/goal_costs.hpp"
#include "wend/planner/lattice/lattice_options.hpp"
#include "wend/robot/motion_primitives.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/space/lattice/lattice_space.hpp"

namespace wend {

/// Where a path may end.
struct LatticeGoal {
  GoalRegion vertices;
  std::bitset<MotionPrimitives::kMostHeadings> headings;  // by index: those accepted

  bool contains(const LatticePose& place) const {
    return headings[static_cast<std::size_t>(place.heading)] && vertices.contains(place.vertex);
  }
};

class LatticePriority {
 public:
  using Key = RealKey<double>;

  LatticePriority(const MotionLattice& lattice, LatticeHeuristic kind, double weight)
      : lattice_(lattice), kind_(kind), weight_(weight) {
    if (kind == LatticeHeuristic::obstacles) {
      around_obstacles_ = std::make_unique<VertexCosts>(VertexSpace(lattice));
    }
  }

  bool allocated() const { return around_obstacles_ == nullptr || around_obstacles_->allocated(); }

  /// At least one goal. Keeps its memory from query to query.
  void begin(std::span<const LatticeGoal> goals, const Limits& limits) {
    goals_.assign(goals.begin(), goals.end());
    if (around_obstacles_ == nullptr) return;
    around_obstacles_->begin(limits);
    for (const LatticeGoal& goal : goals) {
      goal.vertices.for_each(
          [&](Cell vertex) { around_obstacles_->add(around_obstacles_->space().state(vertex)); });
    }
  }

  /// Could the estimates not be made to the end?
  std::optional<SearchOutcome> stopped() const {
    return around_obstacles_ == nullptr ? std::nullopt : around_obstacles_->stopped();
  }

  Key key(const LatticeState& state, double g) const {
    return {g + weight_ * kNotAbove * h(state.place), g};
  }

  bool is_goal(const LatticeState& state) const {
    return std::ranges::any_of(goals_,
                               [&](const LatticeGoal& goal) { return goal.contains(state.place); });
  }

  /// A search without valid estimates stops; the engine asks stopped() why.
  bool near_overflow(const Key& /*key*/) const { return stopped().has_value(); }

  double h(const LatticePose& place) const {
    if (goals_.empty()) return 0;
    switch (kind_) {
      case LatticeHeuristic::zero:
        break;
      case LatticeHeuristic::distance:
        return lattice_.least_cost_per_cell() * straight_distance(place.vertex);
      case LatticeHeuristic::obstacles:
        return (*around_obstacles_)(around_obstacles_->space().state(place.vertex));
    }
    return 0;
  }
  double f(const LatticePose& place, double g) const { return g + weight_ * h(place); }

 private:
  using VertexCosts = GoalCosts<VertexSpace, HeapFrontier<RealKey<double>>, ParentLinks>;

  // Sums are rounded: a hair less keeps an exact estimate from rounding above the true cost.
  static constexpr double kNotAbove = 1 - 1e-12;

  double straight_distance(Cell vertex) const {
    const Cell from = lattice_.cell_of(vertex);
    const auto to = [&](const LatticeGoal& goal) {
      const Cell cell = lattice_.cell_of(goal.vertices.nearest_in_box(vertex));
      return std::hypot(cell.x - from.x, cell.y - from.y);
    };
    double least = to(goals_.front());
    for (const LatticeGoal& goal : goals_) least = std::min(least, to(goal));
    return least;
  }

  MotionLattice lattice_;
  LatticeHeuristic kind_;
  double weight_;
  std::vector<LatticeGoal> goals_;
  std::unique_ptr<VertexCosts> around_obstacles_;
};

}  // namespace wend
