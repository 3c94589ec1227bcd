#pragma once

// KnownJumps: the jumps of a map that has been prepared, as JumpPointSearch asks for them: with shortcuts that
// earlier searches found, without dead ends, and with a node for each jump point of the map.
//
// 32 bytes per jump point, plus JumpGraph, JumpBoards, ShortcutGraph and DeadEnds. One thread; several may share
// the jump graph and the dead ends.

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/state_id.hpp"
#include "wend/jump/dead_ends.hpp"
#include "wend/jump/jump_graph.hpp"
#include "wend/jump/shortcut_graph.hpp"
#include "wend/planner/jump/jump_nodes.hpp"
#include "wend/planner/jump/jump_trail.hpp"

namespace wend {

/// kSearches: the number of searches after which stamps start again.
template <class CostType, std::uint32_t kSearches = std::numeric_limits<std::uint32_t>::max()>
class KnownJumps {
 public:
  using Cost = CostType;
  using Nodes = JumpNodes<Cost, kSearches>;
  using Node = typename Nodes::Node;
  using Jump = wend::Jump;
  using Shortcut = wend::Shortcut;

  KnownJumps(std::shared_ptr<const JumpGraph> graph, std::shared_ptr<const DeadEnds> dead_ends)
      : graph_(std::move(graph)),
        shortcuts_(graph_),
        open_(std::move(dead_ends)),
        nodes_(graph_->size() + 1, graph_->size_after_edits() + 1) {
    take_jump_points(0);
  }

  /// Follows the graph after an edit of the map in these boxes. `changed`: what JumpSources found; null if that
  /// took too long.
  void repair(std::span<const CellBox> boxes, const std::vector<wend::Jump>* changed) {
    if (changed != nullptr) {
      shortcuts_.repair(boxes, *changed);
    } else {
      shortcuts_.forget();
    }
    const auto first_new = static_cast<StateId>(nodes_.size() - 1);
    nodes_.resize(graph_->size() + 1);
    take_jump_points(first_new);
    keep_open(boxes);
  }

  /// Tells what has been edited since the dead ends were found.
  void keep_open(std::span<const CellBox> boxes) {
    std::vector<Cell> near;
    for (const CellBox& box : boxes) {
      const CellBox around = box.grown_by(1).clipped_to(graph_->boards());
      for (int y = around.begin.y; y < around.end.y; ++y) {
        for (int x = around.begin.x; x < around.end.x; ++x) near.push_back({x, y});
      }
    }
    open_.keep_open(near);
  }

  const JumpBoards& ground() const { return graph_->boards(); }
  bool sees(Cell from, Cell to) const { return ground().sight().sees(from, to); }
  bool passes_jump(Cell from, Cell to) const { return ground().passes_jump(from, to); }

  /// Forgets the last search. Returns the node of the start.
  StateId begin(Cell start, std::span<const Cell> goals) {
    nodes_.begin_search();
    open_.open_for(start, goals);
    places_.clear();
    for (const Cell goal : goals) places_.push_back(shortcuts_.raster().place(goal));
    return static_cast<StateId>(nodes_.size() - 1);
  }

  Node& node(StateId id) { return nodes_[id]; }
  const Node& node(StateId id) const { return nodes_[id]; }
  typename Nodes::Stamp stamp(Cost g) const { return nodes_.stamp(g); }
  bool reached(const Node& node) const { return nodes_.reached(node); }

  /// May a path that is better than all before lead through the node?
  bool useful(const Node& node) const { return open_.contains(node.dead_end); }

  DirectionSet directions(StateId id, unsigned arrival) const {
    return graph_->directions(Jump(static_cast<std::uint32_t>(id), arrival));
  }

  /// Calls visit(shortcut) for the jumps from any cell.
  template <class Visit>
  void visit_first(Cell start, Visit&& visit) {
    first_jumps_.clear();
    graph_->append_jumps(start, 0xFF, first_jumps_);
    for (const Jump jump : first_jumps_) {
      visit(Shortcut(jump, start, graph_->cell(jump.number())));
    }
  }

  /// The same for the shortcuts from a node.
  template <class Visit>
  [[gnu::always_inline]] void visit_shortcuts(StateId id, unsigned arrival, Visit&& visit) {
    const ShortcutList shortcuts =
        shortcuts_.shortcuts(Jump(static_cast<std::uint32_t>(id), arrival));
    for (const Shortcut& shortcut : shortcuts) {
      __builtin_prefetch(&nodes_[shortcut.last().number()], 1);
      shortcuts_.prefetch_place(shortcut.last());
    }
    for (const Shortcut& shortcut : shortcuts) visit(shortcut);
  }

  /// May a goal be in sight from a jump point that a shortcut passes?
  bool may_see_goal(const Shortcut& shortcut) const {
    bool may = shortcut.may_see(places_.front());
    for (std::size_t i = 1; i < places_.size(); ++i) may |= shortcut.may_see(places_[i]);
    return may;
  }

  /// Calls visit(jump, cell, directions) for the jump points that a shortcut passes, and its end if that has no
  /// successor, until it returns true. Did it?
  template <class Visit>
  bool visit_passed(const Shortcut& shortcut, Visit&& visit) const {
    for (Jump jump = shortcut.first();; jump = shortcuts_.only_next(jump)) {
      const bool last = jump == shortcut.last();
      if (last && !shortcut.dead()) return false;
      if (visit(jump, graph_->cell(jump.number()), graph_->directions(jump))) return true;
      if (last) return false;
    }
  }

  /// The node at the end of a shortcut.
  StateId end(const Shortcut& shortcut) { return shortcut.last().number(); }
  static Cost cost(const Shortcut& shortcut, Cell from, const Node& end) {
    return shortcut.template cost<Cost>(from, end.cell);
  }
  static unsigned arrival(const Shortcut& shortcut) { return shortcut.last().arrival(); }

  /// A state is often expanded soon after it was reached.
  void prefetch(const Shortcut& shortcut) const { shortcuts_.prefetch_shortcuts(shortcut.last()); }

  /// Appends the jump points from a first one to a cell that its shortcut passes or ends at, backwards.
  void append_back(JumpTrail& trail, Jump first, Cell end) const {
    passed_.clear();
    for (Jump jump = first;; jump = shortcuts_.only_next(jump)) {
      passed_.push_back(graph_->cell(jump.number()));
      if (passed_.back() == end) break;
    }
    trail.append_back(passed_);
  }

 private:
  void take_jump_points(StateId first) {
    for (StateId id = first; id < graph_->size(); ++id) {
      nodes_[id].cell = graph_->cell(static_cast<std::uint32_t>(id));
      nodes_[id].dead_end = open_.number(nodes_[id].cell);
    }
  }

  std::shared_ptr<const JumpGraph> graph_;
  ShortcutGraph shortcuts_;
  OpenDeadEnds open_;
  Nodes nodes_;                      // of the jump points, and of the start
  std::vector<CoarsePlace> places_;  // of the goals
  std::vector<Jump> first_jumps_;    // from the start
  mutable std::vector<Cell> passed_;
};

}  // namespace wend
