#pragma once

// CostToGo: one goal, many starts. Dijkstra's algorithm from the goal gives every cell's cost to
// the goal; from it the best path from any cell comes without searching again, and so does the
// policy, the direction to move in every cell. (Costs are the same both ways.)
//
//   const auto field = wend::CostToGo::make(space, std::array{goal});
//   if (const auto path = field->path_from(start)) ...
//
// O(cells log cells) to make, O(length) a path. Immutable; may be shared between threads.

#include <optional>
#include <span>

#include "wend/base/expected.hpp"
#include "wend/base/limits.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/free_space.hpp"
#include "wend/map/grid.hpp"
#include "wend/planner/plan.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

class CostToGo {
 public:
  /// To the nearest of `goals`. Fails with goal_outside, goal_blocked, unsupported_query (no goal)
  /// or the limit that was reached.
  static Expected<CostToGo, PlanFailure> make(const FreeSpace& space, std::span<const Cell> goals,
                                              GridMoves moves = {}, const Limits& limits = {});

  /// The cheapest cost from a cell to the nearest goal; infinite where no path leads there.
  double cost(Cell cell) const { return costs_[cell]; }
  const Grid<double>& costs() const { return costs_; }

  /// Which way to move from a cell; nothing in a goal and where there is no path.
  std::optional<Direction> policy(Cell cell) const;

  /// The best path from a cell, or the reason why there is none (start_outside, start_blocked,
  /// unreachable).
  Expected<Plan, PlanFailure> path_from(Cell start) const;

  /// The work of making it.
  const SearchMetrics& metrics() const { return metrics_; }

 private:
  explicit CostToGo(FreeSpace space) : space_(std::move(space)) {}

  FreeSpace space_;
  Grid<double> costs_;
  Grid<std::uint8_t> policy_;  // a Direction, or kNoDirection
  SearchMetrics metrics_;
};

}  // namespace wend
