#pragma once

// RunStops: where the straight runs of a search that leaps end.

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "wend/jump/bit_lines.hpp"
#include "wend/planner/goal_region.hpp"

namespace wend {

/// The stops of straight runs: cells that are not interior, and the goals of the present query.
class RunStops {
 public:
  RunStops(BitLines rows, BitLines columns)
      : rows_(std::move(rows)), columns_(std::move(columns)) {}

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

  void set_goals(std::span<const GoalRegion> goals, int width, int height) {
    for (const Cell cell : added_) {
      rows_.reset(cell.y, cell.x);
      columns_.reset(cell.x, cell.y);
    }
    added_.clear();
    for (const GoalRegion& region : goals) {
      region.for_each([&](Cell cell) {
        const bool on_map = cell.x >= 0 && cell.y >= 0 && cell.x < width && cell.y < height;
        if (!on_map || rows_.get(cell.y, cell.x)) return;
        rows_.set(cell.y, cell.x);
        columns_.set(cell.x, cell.y);
        added_.push_back(cell);
      });
    }
  }

 private:
  BitLines rows_;
  BitLines columns_;
  std::vector<Cell> added_;
};

}  // namespace wend
