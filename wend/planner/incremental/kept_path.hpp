#pragma once

// KeptPath: a cheapest path that was found before, and whether it still is one.
//
// After edits, what is left of the path from the robot on is still cheapest if each of its steps is legal and
// costs what it did, and no cell elsewhere that became cheaper, or from which more moves became legal, lies where
// a path through it could be cheaper: the estimates from the start to the cell and from there to the goals say
// that. O(cells left of the path + cells changed); without edits O(1) for each step that the robot made.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "wend/path/path.hpp"
#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/goal_region.hpp"

namespace wend {

template <class Word>
class KeptPath {
 public:
  /// `grid` must live as long. `moves`: those of the planner.
  KeptPath(const CostGrid<Word>& grid, GridMoves moves) : grid_(grid), moves_(moves) {}

  /// Keeps a path, of neighbouring cells, that is cheapest on the grid as it is now.
  void keep(std::span<const Cell> path, std::span<const GoalRegion> goals);

  void forget() { ids_.clear(); }

  /// Is the rest of the path, from a start on it, a cheapest path to these goals?
  bool is_cheapest_from(Cell start, std::span<const GoalRegion> goals);

  /// Writes what is left, from the last start that it was asked about.
  void write(Path& path) const;

 private:
  using Grid = CostGrid<Word>;

  std::uint64_t step_cost(StateId from, StateId to) const;
  bool go_to(Cell start);
  std::optional<std::uint64_t> cost_of_rest() const;
  bool may_lead_past(Cell start, std::uint64_t cost,
                     std::span<const typename Grid::Change> changes) const;
  std::uint64_t least_cost(Cell from, Cell to) const;

  const Grid& grid_;
  GridMoves moves_;
  std::uint64_t log_position_ = 0;
  std::vector<GoalRegion> goals_;
  std::vector<StateId> ids_;          // the cells of the path; none: no path is kept
  std::vector<std::uint64_t> costs_;  // from each of them to the end, as it was kept
  std::size_t at_ = 0;                // where the rest begins
};

}  // namespace wend
