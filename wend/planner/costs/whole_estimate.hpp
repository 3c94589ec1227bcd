#pragma once

// WholeEstimate: the heuristic of a search in whole numbers on a CostGrid.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "wend/planner/goal_cells.hpp"
#include "wend/planner/grid/best_first.hpp"

namespace wend {

/// An estimate that is a sum of straight and diagonal steps, in the Units of the cheapest cell.
template <class Units>
class WholeEstimate {
 public:
  WholeEstimate(const BestFirst& parts, std::uint64_t least_steps)
      : kind_(parts.weight > 0 ? parts.heuristic : HeuristicKind::zero), constant_(parts.constant) {
    set_least_steps(least_steps);
  }

  /// The steps of the cheapest cell.
  void set_least_steps(std::uint64_t least_steps) {
    const std::uint64_t straight = 2 * least_steps * Units::kStraight;
    const std::uint64_t diagonal = 2 * least_steps * Units::kDiagonal;
    if (kind_ == HeuristicKind::manhattan) longer_ = shorter_ = straight;
    if (kind_ == HeuristicKind::octile) {
      longer_ = straight;
      shorter_ = diagonal - straight;
    }
  }

  void begin(std::span<const GoalRegion> goals) { goals_.assign(goals); }
  bool is_goal(Cell cell) const { return goals_.contains(cell); }

  std::uint64_t units(Cell cell) const {
    return goals_.least(cell, [&](Cell goal) {
      const auto dx = static_cast<std::uint64_t>(std::abs(cell.x - goal.x));
      const auto dy = static_cast<std::uint64_t>(std::abs(cell.y - goal.y));
      return longer_ * std::max(dx, dy) + shorter_ * std::min(dx, dy);
    });
  }

  /// As people see it, in cells.
  double cells(Cell cell) const {
    return goals_.least(cell,
                        [&](Cell goal) { return heuristic_value(kind_, constant_, cell, goal); });
  }

 private:
  HeuristicKind kind_;
  double constant_;
  std::uint64_t longer_ = 0;
  std::uint64_t shorter_ = 0;
  GoalCells goals_;
};

}  // namespace wend
