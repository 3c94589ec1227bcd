#pragma once

// RunStops: where the straight runs of a search that leaps end, as bit lines by rows and by columns: cells that
// are not interior (CostGrid), and the goals of the present query.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/jump/bit_lines.hpp"
#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/goal_region.hpp"

namespace wend {

class RunStops {
 public:
  /// O(cells).
  template <class Word>
  explicit RunStops(const CostGrid<Word>& grid) {
    BitLines interior(grid.height(), grid.width());
    for (int y = 0; y < grid.height(); ++y) {
      const auto words = interior.words(y);
      const Word* row = grid.words() + grid.number({0, y});
      for (std::size_t x = 0; x < static_cast<std::size_t>(grid.width()); ++x) {
        const std::uint64_t bit = CostGrid<Word>::interior(row[x]) ? 1 : 0;
        words[(x + 1) / 64] |= bit << ((x + 1) % 64);
      }
    }
    rows_ = all_but(interior);
    columns_ = all_but(interior.transposed());
  }

  /// Follows the changes of the grid that it was made from.
  template <class Word>
  void repair(const CostGrid<Word>& grid,
              std::span<const typename CostGrid<Word>::Change> changes) {
    drop_goals();
    for (const auto& change : changes) {
      const Cell cell = grid.cell(change.id);
      put(cell, !CostGrid<Word>::interior(grid.word(change.id)));
    }
  }

  /// The number of steps from a cell to the first stop in a straight direction.
  std::uint32_t distance(Cell from, unsigned direction) const {
    switch (direction) {
      case 0:
        return static_cast<std::uint32_t>(columns_.distance_ahead(from.x, from.y));
      case 2:
        return static_cast<std::uint32_t>(rows_.distance_ahead(from.y, from.x));
      case 4:
        return static_cast<std::uint32_t>(columns_.distance_back(from.x, from.y));
      default:
        return static_cast<std::uint32_t>(rows_.distance_back(from.y, from.x));
    }
  }

  void set_goals(std::span<const GoalRegion> goals) {
    drop_goals();
    const CellBox map{{0, 0}, {rows_.length(), rows_.lines()}};
    for (const GoalRegion& region : goals) {
      region.for_each([&](Cell cell) {
        if (!map.contains(cell) || rows_.get(cell.y, cell.x)) return;
        put(cell, true);
        added_.push_back(cell);
      });
    }
  }

 private:
  static BitLines all_but(const BitLines& board) {
    return mapped(board, [&](int line, std::size_t i) { return ~board.words(line)[i]; });
  }

  void drop_goals() {
    for (const Cell cell : added_) put(cell, false);
    added_.clear();
  }

  void put(Cell cell, bool stop) {
    if (stop) {
      rows_.set(cell.y, cell.x);
      columns_.set(cell.x, cell.y);
    } else {
      rows_.reset(cell.y, cell.x);
      columns_.reset(cell.x, cell.y);
    }
  }

  BitLines rows_;
  BitLines columns_;
  std::vector<Cell> added_;
};

}  // namespace wend
