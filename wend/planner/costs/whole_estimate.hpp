#pragma once

// WholeEstimate: the heuristic of a search in whole numbers on a CostGrid.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "wend/planner/goal_cells.hpp"
#include "wend/planner/grid/best_first.hpp"

namespace wend {

/// An estimate that is a sum of straight and diagonal steps, in the Units of the cheapest cell, or of the cheapest cells
/// of each column and row.
template <class Units>
class WholeEstimate {
 public:
  WholeEstimate(const BestFirst& parts, std::uint64_t least_steps)
      : kind_(parts.weight > 0 ? parts.heuristic : HeuristicKind::zero),
        constant_(parts.constant),
        longer_(kind_ == HeuristicKind::manhattan || kind_ == HeuristicKind::octile
                    ? Units::kStraight
                    : 0),
        shorter_(kind_ == HeuristicKind::octile ? Units::kDiagonal - Units::kStraight : longer_),
        least_step_(2 * least_steps) {}

  /// The steps of the cheapest cell.
  void set_least_steps(std::uint64_t least_steps) {
    least_step_ = 2 * least_steps;
    columns_ = rows_ = {};
  }

  /// The same where columns and rows differ: for each, the sum of least_steps over the moves from the first one to it and
  /// over both ends of each. They must live as long as they are in use.
  void set_least_sums(std::span<const std::uint64_t> columns, std::span<const std::uint64_t> rows) {
    columns_ = columns;
    rows_ = rows;
  }

  void begin(std::span<const GoalRegion> goals) { goals_.assign(goals); }
  bool is_goal(Cell cell) const { return goals_.contains(cell); }

  std::uint64_t units(Cell cell) const {
    return goals_.least(cell, [&](Cell goal) {
      const std::uint64_t dx = between(columns_, cell.x, goal.x);
      const std::uint64_t dy = between(rows_, cell.y, goal.y);
      return longer_ * std::max(dx, dy) + shorter_ * std::min(dx, dy);
    });
  }

  /// As people see it, in cells.
  double cells(Cell cell) const {
    return goals_.least(cell,
                        [&](Cell goal) { return heuristic_value(kind_, constant_, cell, goal); });
  }

 private:
  std::uint64_t between(std::span<const std::uint64_t> sums, int from, int to) const {
    const int low = std::min(from, to);
    const int high = std::max(from, to);
    if (sums.empty()) return least_step_ * static_cast<std::uint64_t>(high - low);
    return sums[static_cast<std::size_t>(high)] - sums[static_cast<std::size_t>(low)];
  }

  HeuristicKind kind_;
  double constant_;
  std::uint64_t longer_;
  std::uint64_t shorter_;
  std::uint64_t least_step_;
  std::span<const std::uint64_t> columns_;
  std::span<const std::uint64_t> rows_;
  GoalCells goals_;
};

}  // namespace wend
