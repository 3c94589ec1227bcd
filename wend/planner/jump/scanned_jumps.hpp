#pragma once

// ScannedJumps: the jumps of a map of which nothing is prepared, as JumpPointSearch asks for them. It finds each
// jump when the search needs it, on the cells of the map, and keeps nodes only for the jump points that the
// search reaches. Searches take the same paths as with KnownJumps, because both give the same shortcuts in the
// same order; KnownJumps only leaves out dead ends, through which no shortest path leads.
//
// 40 bytes per jump point reached. One thread.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "wend/base/state_id.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/jump/jump_scan.hpp"
#include "wend/jump/shortcut_graph.hpp"
#include "wend/planner/jump/jump_trail.hpp"
#include "wend/planner/jump/reached_cells.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

template <class CostType>
class ScannedJumps {
 public:
  using Cost = CostType;
  using Jump = ScannedJump;

  struct Node {
    Cost stamp = kNever;  // g
    Cell cell;
    StateId parent = 0;
    Jump first;
    std::uint8_t pending = 0;
    std::uint8_t done = 0;

    Cost g() const { return stamp; }
  };

  /// As Shortcut.
  struct Shortcut {
    Jump first_jump;
    Jump last_jump;
    int straight = 0;  // steps
    int diagonal = 0;
    bool ends = false;  // has the last jump point no successor?
    std::uint32_t passed_begin = 0;
    std::uint32_t passed_end = 0;

    Jump first() const { return first_jump; }
    bool dead() const { return ends; }
  };

  /// `passable` must live as long.
  explicit ScannedJumps(const BitGrid& passable) : scan_(passable) {}

  /// Follows the cells after an edit in these boxes.
  void repair(std::span<const CellBox> boxes) {
    for (const CellBox& box : boxes) scan_.forget(box);
    for (Onward& known : onward_) known.count = -1;
  }

  const JumpScan& ground() const { return scan_; }
  bool sees(Cell from, Cell to) { return scan_.sees(from, to); }
  bool passes_jump(Cell from, Cell to) { return scan_.passes_jump(from, to); }

  StateId begin(Cell start, std::span<const Cell> /*goals*/) {
    nodes_.clear();
    return nodes_.at(start);
  }

  Node& node(StateId id) { return nodes_[id]; }
  const Node& node(StateId id) const { return nodes_[id]; }
  static Cost stamp(Cost g) { return g; }
  static bool reached(const Node& node) { return node.stamp != kNever; }
  static bool useful(const Node& /*node*/) { return true; }

  DirectionSet directions(StateId id, unsigned arrival) const {
    return scan_.directions({nodes_[id].cell, arrival});
  }

  template <class Visit>
  void visit_first(Cell start, Visit&& visit) {
    shortcuts_.clear();
    scan_.visit_jumps(start, 0xFF, [&](const Jump& jump) {
      shortcuts_.push_back(single(start, jump));
      return true;
    });
    for (const Shortcut& shortcut : shortcuts_) visit(shortcut);
  }

  template <class Visit>
  void visit_shortcuts(StateId id, unsigned arrival, Visit&& visit) {
    const Cell from = nodes_[id].cell;
    shortcuts_.clear();
    passed_.clear();
    scan_.visit_jumps(from, scan_.directions({from, arrival}), [&](const Jump& jump) {
      shortcuts_.push_back(single(from, jump));
      return true;
    });
    for (Shortcut& shortcut : shortcuts_) extend(shortcut);
    // Dead ones come last, as in ShortcutGraph.
    for (const Shortcut& shortcut : shortcuts_) {
      if (!shortcut.dead()) visit(shortcut);
    }
    for (const Shortcut& shortcut : shortcuts_) {
      if (shortcut.dead()) visit(shortcut);
    }
  }

  bool may_see_goal(const Shortcut& shortcut) const {
    return shortcut.passed_begin != shortcut.passed_end;
  }

  template <class Visit>
  bool visit_passed(const Shortcut& shortcut, Visit&& visit) const {
    for (std::size_t i = shortcut.passed_begin; i < shortcut.passed_end; ++i) {
      if (visit(passed_[i], passed_[i].cell, scan_.directions(passed_[i]))) return true;
    }
    return false;
  }

  StateId end(const Shortcut& shortcut) { return nodes_.at(shortcut.last_jump.cell); }
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
      first = onward(first).next;
      cells_.push_back(first.cell);
    }
    trail.append_back(cells_);
  }

 private:
  static constexpr Cost kNever = std::numeric_limits<Cost>::max();

  static Shortcut single(Cell from, const Jump& jump) {
    const OctileWay way = octile_way(from, jump.cell);
    Shortcut shortcut{.first_jump = jump, .last_jump = jump};
    lengthen(shortcut, way);
    return shortcut;
  }

  /// False if a Shortcut cannot count so many steps.
  static bool lengthen(auto& shortcut, const OctileWay& way) {
    const int straight = shortcut.straight + way.straight;
    const int diagonal = shortcut.diagonal + way.diagonal;
    if (straight > wend::Shortcut::kMostSteps || diagonal > wend::Shortcut::kMostSteps)
      return false;
    shortcut.straight = straight;
    shortcut.diagonal = diagonal;
    return true;
  }

  /// How a path goes on from a jump point.
  struct Onward {
    Jump from;
    Jump next;       // the first successor
    int count = -1;  // of successors, at most 2; less than 0: not known
  };

  /// Several paths reach most jump points.
  const Onward& onward(const Jump& jump) {
    const auto hash =
        static_cast<std::uint32_t>(jump.cell.y * scan_.width() + jump.cell.x) * 4 + jump.arrival;
    Onward& known = onward_[hash * 0x9E3779B1U >> (32 - kOnwardBits)];
    if (known.count >= 0 && known.from == jump) return known;
    known = {.from = jump, .next = {}, .count = 0};
    scan_.visit_jumps(jump.cell, scan_.directions(jump), [&known](const Jump& found) {
      if (known.count == 0) known.next = found;
      return ++known.count < 2;
    });
    return known;
  }

  /// As ShortcutGraph::extend().
  void extend(Shortcut& shortcut) {
    shortcut.passed_begin = shortcut.passed_end = static_cast<std::uint32_t>(passed_.size());
    if (shortcut.straight + shortcut.diagonal == 0) return;  // too long to count
    std::uint64_t marks = mark(shortcut.last_jump);          // of the jumps passed
    for (std::size_t count = 1; count < ShortcutGraph::kMostPassed; ++count) {
      const auto& [from, next, successors] = onward(shortcut.last_jump);
      shortcut.ends = successors == 0;
      if (shortcut.ends) pass(shortcut);
      if (successors != 1) return;
      if ((marks & mark(next)) != 0 && passes(shortcut, next)) return;
      marks |= mark(next);
      if (!lengthen(shortcut, octile_way(shortcut.last_jump.cell, next.cell))) return;
      pass(shortcut);
      shortcut.last_jump = next;
    }
  }

  /// One of 64 bits; another jump may have the same.
  static std::uint64_t mark(const Jump& jump) {
    const auto bit = static_cast<unsigned>(7 * jump.cell.x + 29 * jump.cell.y) + jump.arrival;
    return std::uint64_t{1} << (bit % 64);
  }

  bool passes(const Shortcut& shortcut, const Jump& jump) const {
    const auto passed = std::span(passed_).subspan(shortcut.passed_begin);
    return jump == shortcut.last_jump || std::ranges::find(passed, jump) != passed.end();
  }

  void pass(Shortcut& shortcut) {
    passed_.push_back(shortcut.last_jump);
    shortcut.passed_end = static_cast<std::uint32_t>(passed_.size());
  }

  static constexpr unsigned kOnwardBits = 9;

  JumpScan scan_;
  std::vector<Onward> onward_{std::size_t{1} << kOnwardBits};  // by a hash of the jump
  ReachedCells<Node> nodes_;
  std::vector<Shortcut> shortcuts_;  // of the state being expanded
  std::vector<Jump> passed_;         // by these
  std::vector<Cell> cells_;
};

}  // namespace wend
