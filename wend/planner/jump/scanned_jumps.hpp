#pragma once

// ScannedJumps: the jumps of a map of which nothing is prepared, as JumpPointSearch asks for them. It finds each
// jump when the search needs it, on the cells of the map, and keeps nodes only for the jump points that the
// search reaches. Searches take the same paths as with KnownJumps, because both give the same shortcuts in the
// same order; KnownJumps only leaves out dead ends, through which no shortest path leads.
//
// 40 bytes per jump point reached, and 32 to 64 in the table of their numbers. One thread.

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "wend/base/large_pages.hpp"
#include "wend/base/number_table.hpp"
#include "wend/base/state_id.hpp"
#include "wend/planner/jump/jump_trail.hpp"
#include "wend/planner/jump/scanned_shortcuts.hpp"

namespace wend {

template <class CostType>
class ScannedJumps {
 public:
  using Cost = CostType;
  using Jump = ScannedJump;
  using Shortcut = ScannedShortcut;

  struct Node {
    Cost stamp = kNever;  // g
    Cell cell;
    StateId parent = 0;
    Jump first;
    std::uint8_t pending = 0;
    std::uint8_t done = 0;

    Cost g() const { return stamp; }
  };

  /// `passable` must live as long.
  explicit ScannedJumps(const BitGrid& passable) : shortcuts_(passable) {}

  /// Follows the cells after an edit in these boxes.
  void repair(std::span<const CellBox> boxes) { shortcuts_.repair(boxes); }

  const JumpScan& ground() const { return shortcuts_.scan(); }
  bool sees(Cell from, Cell to) { return shortcuts_.scan().sees(from, to); }
  bool passes_jump(Cell from, Cell to) { return shortcuts_.scan().passes_jump(from, to); }

  StateId begin(Cell start, std::span<const Cell> /*goals*/) {
    nodes_.clear();
    numbers_.clear();
    return at(start);
  }

  Node& node(StateId id) { return nodes_[id]; }
  const Node& node(StateId id) const { return nodes_[id]; }
  static Cost stamp(Cost g) { return g; }
  static bool reached(const Node& node) { return node.stamp != kNever; }
  static bool useful(const Node& /*node*/) { return true; }

  DirectionSet directions(StateId id, unsigned arrival) const {
    return ground().directions({nodes_[id].cell, arrival});
  }

  template <class Visit>
  void visit_first(Cell start, Visit&& visit) {
    for (const Shortcut& shortcut : shortcuts_.find_first(start)) visit(shortcut);
  }

  template <class Visit>
  void visit_shortcuts(StateId id, unsigned arrival, Visit&& visit) {
    const std::span<const Shortcut> found = shortcuts_.find({nodes_[id].cell, arrival});
    // Dead ones come last, as in ShortcutGraph.
    for (const Shortcut& shortcut : found) {
      if (!shortcut.dead()) visit(shortcut);
    }
    for (const Shortcut& shortcut : found) {
      if (shortcut.dead()) visit(shortcut);
    }
  }

  bool may_see_goal(const Shortcut& shortcut) const {
    return shortcut.passed_begin != shortcut.passed_end;
  }

  template <class Visit>
  bool visit_passed(const Shortcut& shortcut, Visit&& visit) const {
    for (const Jump& jump : shortcuts_.passed(shortcut)) {
      if (visit(jump, jump.cell, ground().directions(jump))) return true;
    }
    return false;
  }

  StateId end(const Shortcut& shortcut) { return at(shortcut.last_jump.cell); }
  static Cost cost(const Shortcut& shortcut, Cell from, const Node& end) {
    using Units = OctileUnits<Cost>;
    if (shortcut.straight + shortcut.diagonal == 0) [[unlikely]]
      return octile_cost<Cost>(from, end.cell);
    return Units::kStraight * static_cast<Cost>(shortcut.straight) +
           Units::kDiagonal * static_cast<Cost>(shortcut.diagonal);
  }
  static unsigned arrival(const Shortcut& shortcut) { return shortcut.last_jump.arrival; }
  void prefetch(const Shortcut& /*shortcut*/) const {}

  void append_back(JumpTrail& trail, Jump first, Cell end) {
    cells_.assign(1, first.cell);
    while (cells_.back() != end) {
      first = shortcuts_.next(first);
      cells_.push_back(first.cell);
    }
    trail.append_back(cells_);
  }

 private:
  static constexpr Cost kNever = std::numeric_limits<Cost>::max();

  /// The number of the node at a cell, which is added if it is not there. References to nodes are lost then.
  StateId at(Cell cell) {
    std::uint32_t& number = numbers_[std::uint64_t{static_cast<std::uint32_t>(cell.y)} << 32U |
                                     static_cast<std::uint32_t>(cell.x)];
    if (number == NumberTable<>::kNone) {
      number = static_cast<StateId>(nodes_.size());
      nodes_.emplace_back().cell = cell;
    }
    return number;
  }

  ScannedShortcuts shortcuts_;
  std::vector<Node, LargePages<Node>> nodes_;  // in the order in which they were reached
  NumberTable<> numbers_;                      // by cell
  std::vector<Cell> cells_;
};

}  // namespace wend
