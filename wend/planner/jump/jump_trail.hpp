#pragma once

// JumpTrail: collects the cells where a path turns, from its goal back to its start, from shortcuts and
// jumps.
//
//   wend::JumpTrail trail;
//   trail.begin(goal);
//   trail.append_shortcut(shortcuts, first, end);
//   trail.append(start);
//   draw(trail.from_start());
//
// Between two of these cells all steps have the same direction.

#include <algorithm>
#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/jump/shortcut_graph.hpp"
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

  /// Appends the jump points of a shortcut, backwards from the one with the number `end` to its first.
  void append_shortcut(const ShortcutGraph& shortcuts, Jump first, std::uint32_t end) {
    passed_.clear();
    for (Jump jump = first; jump.number() != end; jump = shortcuts.only_next(jump)) {
      passed_.push_back(shortcuts.jumps().cell(jump.number()));
    }
    append(shortcuts.jumps().cell(end));
    for (const Cell cell : passed_ | std::views::reverse) append(cell);
  }

  /// The cells from start to goal. Valid until the next begin().
  std::span<const Cell> from_start() {
    std::reverse(cells_.begin(), cells_.end());
    return cells_;
  }

 private:
  std::vector<Cell> cells_;
  std::vector<Cell> passed_;  // by the current shortcut
};

}  // namespace wend
