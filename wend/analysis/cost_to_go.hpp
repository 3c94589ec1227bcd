#pragma once

// CostToGo: one goal, many starts. Dijkstra's algorithm from the goal computes every cell's cost to
// the goal. The costs give the best path from any cell without another search, and the policy, the
// direction to move in every cell. (Costs are symmetric.)
//
//   const auto field = wend::CostToGo::make(space, std::array{goal});
//   if (const auto path = field->path_from(start)) ...
//
// On cells with costs the choice among paths is made in whole numbers: a path costs at most 1.5e-6 of the
// least cost more. The costs themselves are those of the chosen paths, with the stored multipliers and the
// exact square root of 2.
//
// O(cells) to make, O(length) a path. Immutable; may be shared between threads.

#include <limits>
#include <optional>
#include <span>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/limits.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/grid.hpp"
#include "wend/planner/failure.hpp"
#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

class WEND_API CostToGo {
 public:
  /// The field to the nearest of `goals`, without those that are off the map or blocked. If none is left,
  /// fails with goal_outside or goal_blocked, as the first is; else with unsupported_query (no goal) or the
  /// limit that was reached.
  static Expected<CostToGo, PlanFailure> make(const FreeSpace& space, std::span<const Cell> goals,
                                              GridMoves moves = {}, const Limits& limits = {});

  /// The cheapest cost from a cell to the nearest goal; infinite without a path, as off the map.
  double cost(Cell cell) const {
    return costs_.contains(cell) ? costs_[cell] : std::numeric_limits<double>::infinity();
  }
  /// cost() of every cell of the map.
  const Grid<double>& costs() const { return costs_; }

  /// The direction to move from a cell; nothing in a goal, without a path and off the map.
  std::optional<Direction> policy(Cell cell) const;

  /// The best path from a cell, or why there is no path (start_outside, start_blocked,
  /// unreachable).
  Expected<Plan, PlanFailure> path_from(Cell start) const;

  /// The work of computing the field.
  const SearchMetrics& metrics() const { return metrics_; }

 private:
  explicit CostToGo(FreeSpace space) : space_(std::move(space)) {}

  FreeSpace space_;
  Grid<double> costs_;
  Grid<std::uint8_t> policy_;  // a Direction, or kNoDirection
  SearchMetrics metrics_;
};

}  // namespace wend
