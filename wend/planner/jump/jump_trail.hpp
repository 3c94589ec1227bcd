#pragma once

// JumpTrail: the cells where a path turns, from its goal back to its start, out of shortcuts and jumps.
//
//   wend::JumpTrail trail;
//   trail.begin(goal);
//   trail.append_shortcut(shortcuts, first, end);
//   trail.append(start);
//   draw(trail.from_start());
//
// Between two of the cells that it gives all steps go the same way.

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

  /// From there one goes to the cell before, diagonally first.
  void append(Cell from) {
    const Cell to = cells_.back();
    const Cell bend = octile_bend(from, to);
    if (bend != to && bend != from) cells_.push_back(bend);
    if (from != to) cells_.push_back(from);
  }

  /// The jump points of a shortcut: backwards from the one with the number `end` to its first.
  void append_shortcut(const ShortcutGraph& shortcuts, Jump first, std::uint32_t end) {
    passed_.clear();
    for (Jump jump = first; jump.number() != end; jump = shortcuts.only_next(jump)) {
      passed_.push_back(shortcuts.jumps().cell(jump.number()));
    }
    append(shortcuts.jumps().cell(end));
    for (const Cell cell : passed_ | std::views::reverse) append(cell);
  }

  /// All of them turned round; until the next begin().
  std::span<const Cell> from_start() {
    std::reverse(cells_.begin(), cells_.end());
    return cells_;
  }

 private:
  std::vector<Cell> cells_;
  std::vector<Cell> passed_;  // by the shortcut in work
};

}  // namespace wend
