#pragma once

// JumpPointSearch: A* that jumps from one jump point to the next and skips the cells between.
//
//   wend::JumpPointSearch<std::uint32_t> search(graph, dead_ends);
//   search.begin({1, 1}, goals, limits);
//   if (search.run() == wend::SearchOutcome::found) draw(search.waypoints());
//
// A state is a jump point with the straight directions of its arrivals, all at the same cost. A state
// that sees a goal opens no states, because no other path is shorter. Where there is no choice, the
// search takes a shortcut over several jump points (ShortcutGraph), and looks for a goal from each of
// them if the shortcut may see one. Open states lie in buckets that are not sorted exactly, so a state
// may be expanded again when a cheaper path to it is found. The search ends when the current bucket is
// past the cost of the cheapest path found.
//
// Optimal. 32 bytes per jump point, plus JumpGraph, JumpBoards, ShortcutGraph and DeadEnds. One thread
// per search; searches may share the jump graph and the dead ends.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/base/state_id.hpp"
#include "wend/jump/dead_ends.hpp"
#include "wend/jump/jump_graph.hpp"
#include "wend/jump/shortcut_graph.hpp"
#include "wend/planner/jump/goal_sight.hpp"
#include "wend/planner/jump/jump_nodes.hpp"
#include "wend/planner/jump/jump_trail.hpp"
#include "wend/search/jump_queue.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

/// The default watcher. It does nothing and costs nothing.
struct NoJumpWatcher {
  void on_generate(Cell, Cell, auto) const {}
  void on_expand(Cell, Cell, auto) const {}
  void on_reach(Cell, Cell, auto, bool) const {}
};

/// kSearches: the number of searches after which stamps start again.
template <class CostType, std::uint32_t kSearches = std::numeric_limits<std::uint32_t>::max()>
class JumpPointSearch {
 public:
  using Cost = CostType;
  using Units = OctileUnits<Cost>;

  JumpPointSearch(std::shared_ptr<const JumpGraph> graph,
                  std::shared_ptr<const DeadEnds> dead_ends);

  /// Forgets the last search. The start and places of goals are passable; `limits` must live as long as the
  /// search. A watcher receives each cell, its parent (for the start: itself) and g.
  template <class Watcher = NoJumpWatcher>
  void begin(Cell start, std::span<const GoalRegion> goals, const Limits& limits,
             Watcher&& watcher = {});

  /// Expands one state.
  template <class Watcher = NoJumpWatcher>
  void step(Watcher&& watcher = {});

  /// Runs until there is an outcome.
  template <class Watcher = NoJumpWatcher>
  SearchOutcome run(Watcher&& watcher = {}) {
    while (outcome_ == SearchOutcome::running) step(watcher);
    return outcome_;
  }

  SearchOutcome outcome() const { return outcome_; }
  const SearchMetrics& metrics() const { return metrics_; }

  /// The start, the turning cells and the goal of the path found. Between two of them all steps have the
  /// same direction. Valid until the next call.
  std::span<const Cell> waypoints();

  /// Calls visit(cell, parent, g, newest) for the states that would be expanded next, in that order, at
  /// most `most` of them. The parent of the start is itself. newest: the state lies in the same bucket
  /// as the one before, where the newest comes first. Returns the number of open states. Works on a copy
  /// of the queue: O(its entries).
  template <class Visit>
  std::uint64_t for_each_open(std::size_t most, Visit&& visit) const;

  /// The estimate to the nearest goal of the search begun last, in units.
  Cost h(Cell cell) const { return goals_.h(cell); }

 private:
  static constexpr Cost kInfinite = GoalSight<Cost>::kInfinite;

  using View = typename GoalSight<Cost>::View;
  using Nodes = JumpNodes<Cost, kSearches>;
  using Node = typename Nodes::Node;

  static constexpr Jump kNoJump = Jump(std::numeric_limits<std::uint32_t>::max());

  /// A state that sees a goal: a node, or a jump point on a shortcut from a node.
  struct Seer {
    StateId node = 0;
    Jump first = kNoJump;  // of the shortcut
    Jump last = kNoJump;
  };

  /// The start is the node after the jump points.
  StateId start_id() const { return static_cast<StateId>(nodes_.size() - 1); }

  View look(Cell from, DirectionSet directions, Cost g) {
    return goals_.look(graph_->boards().sight(), from, directions, g);
  }
  bool look_from_passed(const Shortcut& shortcut, const Node& from, StateId parent);

  template <class Watcher>
  void expand(StateId id, Watcher& watcher);
  template <class Watcher>
  void expand_start(Watcher& watcher);
  template <class Watcher>
  void finish(Watcher& watcher);
  template <class Watcher>
  [[gnu::always_inline]] inline void reach(const Shortcut& shortcut, const Node& from,
                                           StateId parent, Watcher& watcher);

  std::shared_ptr<const JumpGraph> graph_;
  ShortcutGraph shortcuts_;
  OpenDeadEnds open_;
  Nodes nodes_;
  JumpQueue<Cost> queue_;
  GoalSight<Cost> goals_;
  Seer seer_;                      // of the cheapest goal
  std::vector<Jump> first_jumps_;  // from the start
  bool too_wide_;                  // for an octile distance to be surely below half of kInfinite

  bool overflown_ = false;

  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
  std::uint64_t most_expansions_ = 0;
  LimitCheck limits_;
  JumpTrail trail_;
};

template <class Cost, std::uint32_t kSearches>
JumpPointSearch<Cost, kSearches>::JumpPointSearch(std::shared_ptr<const JumpGraph> graph,
                                                  std::shared_ptr<const DeadEnds> dead_ends)
    : graph_(std::move(graph)),
      shortcuts_(graph_),
      open_(std::move(dead_ends)),
      nodes_(graph_->size() + 1) {
  const JumpBoards& boards = graph_->boards();
  const std::uint64_t steps =
      static_cast<std::uint64_t>(boards.width()) + static_cast<std::uint64_t>(boards.height());
  too_wide_ = steps > kInfinite / 2 / Units::kStraight;
  for (StateId id = 0; id < graph_->size(); ++id) {
    nodes_[id].cell = graph_->cell(static_cast<std::uint32_t>(id));
    nodes_[id].dead_end = open_.number(nodes_[id].cell);
  }
}

template <class Cost, std::uint32_t kSearches>
template <class Watcher>
void JumpPointSearch<Cost, kSearches>::begin(Cell start, std::span<const GoalRegion> goals,
                                             const Limits& limits, Watcher&& watcher) {
  // A bucket is nearly a straight step wide.
  constexpr auto kWidthBits = static_cast<unsigned>(std::bit_width(Units::kStraight) - 1);
  limits_.begin(limits);
  most_expansions_ = limits.expansions;
  metrics_ = {.expanded = 0, .generated = 1, .max_frontier = 1};
  overflown_ = false;
  outcome_ = too_wide_ ? SearchOutcome::cost_overflow : SearchOutcome::running;
  nodes_.begin_search();
  goals_.begin(goals, start, graph_->boards(), shortcuts_.raster());
  open_.open_for(start, goals_.cells());
  queue_.begin(h(start), kWidthBits);
  Node& node = nodes_[start_id()];
  node.stamp = nodes_.stamp(0);
  node.cell = start;
  node.parent = start_id();
  node.pending = 1;
  queue_.push(h(start), start_id());
  watcher.on_generate(start, start, Cost{0});
}

template <class Cost, std::uint32_t kSearches>
template <class Watcher>
void JumpPointSearch<Cost, kSearches>::step(Watcher&& watcher) {
  while (!queue_.empty()) {
    const auto entry = queue_.pop();
    if (queue_.bucket_is_behind(goals_.best())) break;
    // It was reached more cheaply or expanded since then.
    if (entry.f >= goals_.best() || nodes_[entry.id].pending == 0) continue;
    if (limits_.due(metrics_.expanded)) {
      outcome_ = limits_.look(metrics_.expanded);
      if (outcome_ != SearchOutcome::running) return;
    }
    ++metrics_.expanded;
    if (entry.id == start_id()) {
      expand_start(watcher);
    } else {
      expand(entry.id, watcher);
    }
    metrics_.max_frontier = std::max(metrics_.max_frontier, metrics_.generated - metrics_.expanded);
    if (overflown_ || goals_.overflown()) outcome_ = SearchOutcome::cost_overflow;
    return;
  }
  finish(watcher);
}

template <class Cost, std::uint32_t kSearches>
template <class Watcher>
void JumpPointSearch<Cost, kSearches>::finish(Watcher& watcher) {
  if (goals_.best() == kInfinite) {
    outcome_ = SearchOutcome::exhausted;
    return;
  }
  const Cell from = nodes_[seer_.node].cell;
  const bool expanded = from == goals_.goal();  // before
  if (!expanded && metrics_.expanded >= most_expansions_) {
    outcome_ = SearchOutcome::expansion_limit;
    return;
  }
  outcome_ = SearchOutcome::found;
  if (expanded) return;
  ++metrics_.generated;
  ++metrics_.expanded;
  watcher.on_generate(goals_.goal(), from, goals_.best());
  watcher.on_expand(goals_.goal(), from, goals_.best());
}

template <class Cost, std::uint32_t kSearches>
template <class Watcher>
void JumpPointSearch<Cost, kSearches>::expand_start(Watcher& watcher) {
  constexpr DirectionSet kEveryDirection = 0xFF;
  Node& start = nodes_[start_id()];
  start.pending = 0;
  watcher.on_expand(start.cell, start.cell, Cost{0});
  const View view = look(start.cell, kEveryDirection, 0);
  if (view.better) seer_ = {start_id(), kNoJump, kNoJump};
  if (view.nearest) return;
  first_jumps_.clear();
  graph_->append_jumps(start.cell, kEveryDirection, first_jumps_);
  for (const Jump jump : first_jumps_) {
    reach(Shortcut(jump, start.cell, graph_->cell(jump.number())), start, start_id(), watcher);
  }
}

template <class Cost, std::uint32_t kSearches>
template <class Watcher>
void JumpPointSearch<Cost, kSearches>::expand(StateId id, Watcher& watcher) {
  Node& node = nodes_[id];
  watcher.on_expand(node.cell, nodes_[node.parent].cell, node.g());
  const unsigned arrivals = std::exchange(node.pending, std::uint8_t{0});
  node.done |= static_cast<std::uint8_t>(arrivals);
  const auto for_each_arrival = [&](auto&& visit) {
    for (unsigned rest = arrivals; rest != 0; rest &= rest - 1) {
      visit(Jump(static_cast<std::uint32_t>(id), static_cast<unsigned>(std::countr_zero(rest))));
    }
  };
  DirectionSet directions = 0;
  for_each_arrival([&](Jump state) { directions |= graph_->directions(state); });
  const View view = look(node.cell, directions, node.g());
  if (view.better) seer_ = {id, kNoJump, kNoJump};
  if (view.nearest) return;
  for_each_arrival([&](Jump state) {
    const ShortcutList shortcuts = shortcuts_.shortcuts(state);
    for (const Shortcut& shortcut : shortcuts) {
      __builtin_prefetch(&nodes_[shortcut.last().number()], 1);
      shortcuts_.prefetch_place(shortcut.last());
    }
    for (const Shortcut& shortcut : shortcuts) reach(shortcut, node, id, watcher);
  });
}

template <class Cost, std::uint32_t kSearches>
template <class Watcher>
inline void JumpPointSearch<Cost, kSearches>::reach(const Shortcut& shortcut, const Node& from,
                                                    StateId parent, Watcher& watcher) {
  if (goals_.may_be_seen(shortcut) && look_from_passed(shortcut, from, parent)) return;
  if (shortcut.dead()) return;
  const Jump jump = shortcut.last();
  Node& node = nodes_[jump.number()];
  const Cost g = from.g() + shortcut.template cost<Cost>(from.cell, node.cell);
  const auto stamp = nodes_.stamp(g);
  if (stamp > node.stamp) return;
  if (stamp < node.stamp && !open_.contains(node.dead_end)) return;
  // No branch: what earlier searches left in a node is hard to predict.
  const bool open = nodes_.reached(node) & (node.pending != 0);
  const auto arrival = static_cast<std::uint8_t>(1U << jump.arrival());
  if (stamp < node.stamp) {
    node.stamp = stamp;
    node.parent = parent;
    node.first = shortcut.first();
    node.pending = arrival;
    node.done = 0;
  } else {
    // At equal cost only a new direction counts.
    if ((arrival & (node.pending | node.done)) != 0) return;
    node.pending |= arrival;
    if (open) return;
  }
  metrics_.generated += open ? 0 : 1;
  watcher.on_reach(node.cell, from.cell, g, open);
  const Cost f = g + h(node.cell);
  if (g < from.g() || f < g || f == kInfinite) {  // more than the type holds
    overflown_ = true;
    return;
  }
  shortcuts_.prefetch_shortcuts(jump);  // a state is often expanded soon after it was reached
  queue_.push(f, jump.number());
}

template <class Cost, std::uint32_t kSearches>
template <class Visit>
std::uint64_t JumpPointSearch<Cost, kSearches>::for_each_open(std::size_t most,
                                                              Visit&& visit) const {
  if (outcome_ != SearchOutcome::running) return 0;
  JumpQueue<Cost> rest = queue_;
  std::unordered_set<StateId> open;  // older entries of a state are skipped
  std::optional<std::size_t> bucket;
  while (!rest.empty()) {
    const auto entry = rest.pop();
    if (rest.bucket_is_behind(goals_.best())) break;
    const Node& node = nodes_[entry.id];
    if (entry.f >= goals_.best() || node.pending == 0 || !open.insert(entry.id).second) continue;
    if (open.size() > most) continue;
    const std::size_t here = rest.bucket_of(entry.f);
    visit(node.cell, nodes_[node.parent].cell, node.g(), here == bucket);
    bucket = here;
  }
  const Cell from = nodes_[seer_.node].cell;
  const bool goal_is_last = goals_.best() != kInfinite && from != goals_.goal();
  if (!goal_is_last) return open.size();
  if (open.size() < most) visit(goals_.goal(), from, goals_.best(), false);
  return open.size() + 1;
}

/// Looks for goals from the jump points that a shortcut passes, and from its end if that has no
/// successor. True if no path that continues is shorter.
template <class Cost, std::uint32_t kSearches>
bool JumpPointSearch<Cost, kSearches>::look_from_passed(const Shortcut& shortcut, const Node& from,
                                                        StateId parent) {
  Cell at = from.cell;
  Cost g = from.g();
  for (Jump jump = shortcut.first();; jump = shortcuts_.only_next(jump)) {
    const bool last = jump == shortcut.last();
    if (last && !shortcut.dead()) return false;
    const Cell cell = graph_->cell(jump.number());
    const Cost reached = g + octile_cost<Cost>(std::exchange(at, cell), cell);
    if (reached < g) {  // more than the type holds
      overflown_ = true;
      return true;
    }
    g = reached;
    const View view = look(cell, graph_->directions(jump), g);
    if (view.better) seer_ = {parent, shortcut.first(), jump};
    if (view.nearest || last) return true;
  }
}

template <class Cost, std::uint32_t kSearches>
std::span<const Cell> JumpPointSearch<Cost, kSearches>::waypoints() {
  trail_.begin(goals_.goal());
  if (seer_.first != kNoJump) trail_.append_shortcut(shortcuts_, seer_.first, seer_.last.number());
  for (StateId id = seer_.node; id != start_id(); id = nodes_[id].parent) {
    trail_.append_shortcut(shortcuts_, nodes_[id].first, static_cast<std::uint32_t>(id));
  }
  trail_.append(nodes_[start_id()].cell);
  return trail_.from_start();
}

}  // namespace wend
