#pragma once

// KeptRoots: the goals from which a search backwards has begun, and whether the search can go on from query to query.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "wend/geometry/cell_box.hpp"
#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/goal_region.hpp"

namespace wend {

template <class Word>
class KeptRoots {
 public:
  using Grid = CostGrid<Word>;
  using Changes = std::span<const typename Grid::Change>;

  /// Takes the goals of the next query. Returns what has changed on the grid since the last one if the search can go
  /// on; nothing if it must begin anew: for other goals, after an edit of a goal, when the least cost of all cells
  /// is another one, or after more edits than the grid's log holds.
  std::optional<Changes> take(const Grid& grid, std::span<const GoalRegion> goals) {
    const auto changes = grid.changes_since(log_position_);
    const bool keeps = least_steps_ == grid.least_steps() && std::ranges::equal(goals, goals_) &&
                       changes && !changes_a_root(grid, *changes);
    goals_.assign(goals.begin(), goals.end());
    least_steps_ = grid.least_steps();
    log_position_ = grid.log_end();
    return keeps ? changes : std::nullopt;
  }

  /// Is the cell in one of the goals?
  bool contains(Cell cell) const { return any_contains(goals_, cell); }

  /// Visits the free cells of the goals; those of two goals twice.
  template <class Visit>
  void for_each(const Grid& grid, Visit&& visit) const {
    const CellBox map{{0, 0}, {grid.width(), grid.height()}};
    for (const GoalRegion& goal : goals_) {
      goal.for_each([&](Cell cell) {
        if (!map.contains(cell)) return;
        const StateId id = grid.number(cell);
        if (grid.word(id) != 0) visit(id);
      });
    }
  }

 private:
  bool changes_a_root(const Grid& grid, Changes changes) const {
    return std::ranges::any_of(changes, [&](const auto& change) {
      return Grid::steps(change.before) != Grid::steps(grid.word(change.id)) &&
             contains(grid.cell(change.id));
    });
  }

  std::vector<GoalRegion> goals_;  // none: there was no query
  std::uint64_t least_steps_ = 0;
  std::uint64_t log_position_ = 0;
};

}  // namespace wend
