#pragma once

// JumpPointSearch: A* that jumps from one jump point to the next and leaves out what lies between.
//
//   wend::JumpPointSearch<std::uint32_t> search(boards, dead_ends);
//   search.begin({1, 1}, goals, limits);
//   if (search.run() == wend::SearchOutcome::found) draw(search.waypoints());
//
// A state is a jump point together with the straight directions it was reached in, all by equally
// cheap ways. A state that sees a goal opens nothing: no way is shorter. Open states lie in buckets
// whose order is inexact, so a state may be expanded again when a cheaper way to it comes, and the
// search ends when the bucket in work is past the cheapest way found.
//
// Optimal. 24 bytes a jump point, and what JumpGraph, JumpBoards and DeadEnds take. One thread a
// search; boards and dead ends are shared.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/base/state_id.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/jump_queue.hpp"
#include "wend/search/search_metrics.hpp"
#include "wend/space/dead_ends.hpp"
#include "wend/space/jump_boards.hpp"
#include "wend/space/jump_graph.hpp"
#include "wend/space/octile_units.hpp"

namespace wend {

/// Watches nothing, and costs nothing.
struct NoJumpWatcher {
  void on_generate(Cell, Cell, auto) const {}
  void on_expand(Cell, Cell, auto) const {}
  void on_relax(Cell, Cell, auto) const {}
};

template <class CostType, std::uint32_t kLastGeneration = std::numeric_limits<std::uint32_t>::max()>
class JumpPointSearch {
 public:
  using Cost = CostType;
  using Units = OctileUnits<Cost>;

  JumpPointSearch(std::shared_ptr<const JumpBoards> boards,
                  std::shared_ptr<const DeadEnds> dead_ends);

  /// Forgets the last search. Cells are as drawn and passable; `limits` must live as long as the
  /// search. A watcher is told cells, the cells they were reached from (of the start: itself) and g.
  template <class Watcher = NoJumpWatcher>
  void begin(Cell start, std::span<const Cell> goals, const Limits& limits, Watcher&& watcher = {});

  /// Expands one state.
  template <class Watcher = NoJumpWatcher>
  void step(Watcher&& watcher = {});

  /// Goes on until there is an outcome.
  template <class Watcher = NoJumpWatcher>
  SearchOutcome run(Watcher&& watcher = {}) {
    while (outcome_ == SearchOutcome::running) step(watcher);
    return outcome_;
  }

  SearchOutcome outcome() const { return outcome_; }
  const SearchMetrics& metrics() const { return metrics_; }

  /// Of a search that found a way: its start, the cells where it turns, its goal. Between two of
  /// them all steps go the same way. Replaced by the next call.
  std::span<const Cell> waypoints();

  /// Of the search begun last.
  std::size_t goal_count() const { return goals_.size(); }

  /// The estimate to the nearest goal, in units; there must be one.
  Cost h(Cell cell) const {
    Cost least = octile(cell, goals_.front());
    for (std::size_t i = 1; i < goals_.size(); ++i) {
      least = std::min(least, octile(cell, goals_[i]));
    }
    return least;
  }

 private:
  static constexpr Cost kInfinite = std::numeric_limits<Cost>::max();

  struct Node {
    Cell cell;
    Cost g;
    StateId parent;
    std::uint32_t generation;  // of the search that reached it; 0: never
    std::uint8_t pending;      // arrivals to be expanded, a bit each
    std::uint8_t done;         // arrivals that were, as cheaply
    bool in_dead_end;
  };

  static Cost octile(Cell from, Cell to) {
    const auto dx = static_cast<Cost>(std::abs(to.x - from.x));
    const auto dy = static_cast<Cost>(std::abs(to.y - from.y));
    return Units::kStraight * std::max(dx, dy) +
           (Units::kDiagonal - Units::kStraight) * std::min(dx, dy);
  }

  /// The start is the node behind the jump points.
  StateId start_id() const { return static_cast<StateId>(nodes_.size() - 1); }

  void next_generation();
  bool within_limits();
  bool see_goal(const Node& node, DirectionSet directions, StateId id);

  template <class Watcher>
  void expand(StateId id, Watcher& watcher);
  template <class Watcher>
  void finish(Watcher& watcher);
  template <class Watcher>
  void reach(Jump jump, const Node& from, StateId parent, Watcher& watcher);

  JumpGraph graph_;
  OpenDeadEnds open_;
  std::vector<Node> nodes_;
  std::uint32_t generation_ = 0;
  JumpQueue<Cost> queue_;
  std::vector<Cell> goals_;
  std::vector<Jump> first_jumps_;  // from the start

  Cost best_ = 0;          // the cheapest way to a goal so far
  StateId seen_from_ = 0;  // the state that sees that goal
  Cell goal_{};
  bool overflown_ = false;

  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
  const Limits* limits_ = nullptr;
  double deadline_ = 0;
  std::uint64_t next_check_ = 0;
  std::vector<Cell> waypoints_;
};

/// The way to a cell by diagonal steps first begins in this direction; none for the cell itself.
constexpr DirectionSet first_direction(Cell from, Cell to) {
  using enum Direction;
  constexpr std::array<DirectionSet, 9> kByNeighbour{
      set_of(up_left), set_of(up),        set_of(up_right), set_of(left),      0,
      set_of(right),   set_of(down_left), set_of(down),     set_of(down_right)};
  const int right_of = static_cast<int>(to.x > from.x) - static_cast<int>(to.x < from.x);
  const int below = static_cast<int>(to.y > from.y) - static_cast<int>(to.y < from.y);
  return kByNeighbour[static_cast<std::size_t>(4 + 3 * below + right_of)];
}

template <class Cost, std::uint32_t kLast>
JumpPointSearch<Cost, kLast>::JumpPointSearch(std::shared_ptr<const JumpBoards> boards,
                                              std::shared_ptr<const DeadEnds> dead_ends)
    : graph_(std::move(boards)), open_(std::move(dead_ends)), nodes_(graph_.size() + 1) {
  for (StateId id = 0; id < graph_.size(); ++id) {
    nodes_[id].cell = graph_.cell(id);
    nodes_[id].in_dead_end = !open_.in_core(nodes_[id].cell);
  }
}

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::begin(Cell start, std::span<const Cell> goals,
                                         const Limits& limits, Watcher&& watcher) {
  // A bucket is nearly a straight step wide.
  constexpr auto kWidthBits = static_cast<unsigned>(std::bit_width(Units::kStraight) - 1);
  limits_ = &limits;
  deadline_ = limits.clock ? limits.clock() + limits.seconds : 0;
  next_check_ = 0;
  metrics_ = {.expanded = 0, .generated = 1, .max_frontier = 1};
  overflown_ = false;
  best_ = kInfinite;
  outcome_ = SearchOutcome::running;
  next_generation();
  goals_.assign(goals.begin(), goals.end());
  open_.open_for(start, goals);
  queue_.begin(h(start), kWidthBits);
  nodes_.back() = {start, 0, start_id(), generation_, 1, 0, false};
  queue_.push(h(start), start_id());
  watcher.on_generate(start, start, Cost{0});
}

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::step(Watcher&& watcher) {
  while (!queue_.empty()) {
    const auto entry = queue_.pop();
    if (queue_.bucket_is_behind(best_)) break;
    // Of no use any more, or expanded meanwhile.
    if (entry.f >= best_ || nodes_[entry.id].pending == 0) continue;
    if (metrics_.expanded == next_check_ && !within_limits()) return;
    expand(entry.id, watcher);
    metrics_.max_frontier = std::max(metrics_.max_frontier, metrics_.generated - metrics_.expanded);
    if (overflown_) outcome_ = SearchOutcome::cost_overflow;
    return;
  }
  finish(watcher);
}

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::finish(Watcher& watcher) {
  if (best_ == kInfinite) {
    outcome_ = SearchOutcome::exhausted;
    return;
  }
  const Cell from = nodes_[seen_from_].cell;
  const bool expanded = from == goal_;  // before
  if (!expanded && metrics_.expanded >= limits_->expansions) {
    outcome_ = SearchOutcome::expansion_limit;
    return;
  }
  outcome_ = SearchOutcome::found;
  if (expanded) return;
  ++metrics_.generated;
  ++metrics_.expanded;
  watcher.on_generate(goal_, from, best_);
  watcher.on_expand(goal_, from, best_);
}

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::expand(StateId id, Watcher& watcher) {
  constexpr DirectionSet kEveryDirection = 0xFF;
  Node& node = nodes_[id];
  ++metrics_.expanded;
  watcher.on_expand(node.cell, nodes_[node.parent].cell, node.g);
  const unsigned arrivals = std::exchange(node.pending, std::uint8_t{0});
  node.done |= static_cast<std::uint8_t>(arrivals);
  if (id == start_id()) {
    if (see_goal(node, kEveryDirection, id)) return;
    first_jumps_.clear();
    graph_.append_jumps(node.cell, kEveryDirection, first_jumps_);
    for (const Jump jump : first_jumps_) reach(jump, node, id, watcher);
    return;
  }
  DirectionSet directions = 0;
  for (unsigned rest = arrivals; rest != 0; rest &= rest - 1) {
    directions |= graph_.directions(id, static_cast<unsigned>(std::countr_zero(rest)));
  }
  if (see_goal(node, directions, id)) return;
  for (unsigned rest = arrivals; rest != 0; rest &= rest - 1) {
    const auto arrival = static_cast<unsigned>(std::countr_zero(rest));
    const auto jumps = graph_.jumps(id, arrival);
    for (const Jump jump : jumps) __builtin_prefetch(&nodes_[jump.number()], 1);  // 5 % faster
    for (const Jump jump : jumps) reach(jump, node, id, watcher);
  }
}

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::reach(Jump jump, const Node& from, StateId parent,
                                         Watcher& watcher) {
  Node& node = nodes_[jump.number()];
  const std::uint64_t g = std::uint64_t{from.g} + octile(from.cell, node.cell);
  const auto arrival = static_cast<std::uint8_t>(1U << jump.arrival());
  const bool known = node.generation == generation_;
  if (known && g > node.g) return;
  const bool open = known && node.pending != 0;
  if (!known || g < node.g) {
    if (node.in_dead_end && !open_.contains(node.cell)) return;
    node.g = static_cast<Cost>(g);
    node.parent = parent;
    node.generation = generation_;
    node.pending = arrival;
    node.done = 0;
  } else {
    // A new direction counts where the way is as cheap.
    if ((arrival & (node.pending | node.done)) != 0) return;
    node.pending |= arrival;
    if (open) return;
  }
  if (open) {
    watcher.on_relax(node.cell, from.cell, node.g);
  } else {
    ++metrics_.generated;
    watcher.on_generate(node.cell, from.cell, node.g);
  }
  const std::uint64_t f = g + h(node.cell);
  if (f >= kInfinite) {
    overflown_ = true;
  } else {
    queue_.push(static_cast<Cost>(f), jump.number());
  }
}

/// Is the nearest goal in sight? Then no way from here is shorter than the straight one to it. Goals
/// in other directions than these are reached as cheaply by other ways.
template <class Cost, std::uint32_t kLast>
bool JumpPointSearch<Cost, kLast>::see_goal(const Node& node, DirectionSet directions, StateId id) {
  bool seen_nearest = false;
  for (const Cell goal : goals_) {
    const bool ahead = (directions & first_direction(node.cell, goal)) != 0 || goal == node.cell;
    if (!ahead || !graph_.boards().in_sight(node.cell, goal)) continue;
    const Cost distance = octile(node.cell, goal);
    seen_nearest = seen_nearest || distance == h(node.cell);
    const auto cost = static_cast<Cost>(node.g + distance);
    if (cost >= best_) continue;
    best_ = cost;
    seen_from_ = id;
    goal_ = goal;
  }
  return seen_nearest;
}

template <class Cost, std::uint32_t kLast>
void JumpPointSearch<Cost, kLast>::next_generation() {
  if (generation_ == kLast) {
    for (Node& node : nodes_) node.generation = 0;
    generation_ = 0;
  }
  ++generation_;
}

template <class Cost, std::uint32_t kLast>
bool JumpPointSearch<Cost, kLast>::within_limits() {
  const std::uint64_t expanded = metrics_.expanded;
  if (expanded >= limits_->expansions) {
    outcome_ = SearchOutcome::expansion_limit;
  } else if (limits_->cancel != nullptr && limits_->cancel->load(std::memory_order_relaxed)) {
    outcome_ = SearchOutcome::cancelled;
  } else if (limits_->clock && limits_->clock() > deadline_) {
    outcome_ = SearchOutcome::time_limit;
  }
  next_check_ = std::min(limits_->expansions, expanded + Limits::kExpansionsBetweenClockReads);
  return outcome_ == SearchOutcome::running;
}

template <class Cost, std::uint32_t kLast>
std::span<const Cell> JumpPointSearch<Cost, kLast>::waypoints() {
  waypoints_.clear();
  Cell to = goal_;
  waypoints_.push_back(to);
  for (StateId id = seen_from_;; id = nodes_[id].parent) {
    const Cell from = nodes_[id].cell;
    const int right = to.x - from.x;
    const int down = to.y - from.y;
    const int diagonal = std::min(std::abs(right), std::abs(down));
    const Cell turn{from.x + (right < 0 ? -diagonal : diagonal),
                    from.y + (down < 0 ? -diagonal : diagonal)};
    if (turn != to && turn != from) waypoints_.push_back(turn);
    if (from != to) waypoints_.push_back(from);
    if (id == start_id()) break;
    to = from;
  }
  std::reverse(waypoints_.begin(), waypoints_.end());
  return waypoints_;
}

}  // namespace wend
