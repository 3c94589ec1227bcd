#pragma once

// JumpTrail: collects the cells where a path turns, from its goal back to its start, from the jump points that
// it passes.
//
//   wend::JumpTrail trail;
//   trail.begin(goal);
//   trail.append_back(jump_points);
//   trail.append(start);
//   draw(trail.from_start());
//
// Between two of these cells all steps have the same direction.

#include <algorithm>
#include <ranges>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

class JumpTrail {
 public:
  void begin(Cell goal) { cells_.assign(1, goal); }

  /// Appends a cell from which the path goes to the last one, diagonally first.
  void append(Cell from) {
    const Cell to = cells_.back();
    const Cell bend = octile_bend(from, to);
    if (bend != to && bend != from) cells_.push_back(bend);
    if (from != to) cells_.push_back(from);
  }

  /// The same for some cells that the path passes one after the other, of which the last comes first.
  void append_back(std::span<const Cell> cells) {
    for (const Cell cell : cells | std::views::reverse) append(cell);
  }

  /// The cells from start to goal. Valid until the next begin().
  std::span<const Cell> from_start() {
    std::reverse(cells_.begin(), cells_.end());
    return cells_;
  }

 private:
  std::vector<Cell> cells_;
};

}  // namespace wend
