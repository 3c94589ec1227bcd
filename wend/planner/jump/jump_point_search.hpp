#pragma once

// JumpPointSearch: A* that jumps from one jump point to the next and skips the cells between.
//
//   wend::JumpPointSearch search(wend::ScannedJumps<std::uint32_t>(space.passable()));
//   search.begin({1, 1}, goals, limits);
//   if (search.run() == wend::SearchOutcome::found) draw(search.waypoints());
//
// A state is a jump point with the straight directions of its arrivals, all at the same cost. A state
// that sees a goal opens no states, because no other path is shorter. Where there is no choice, the
// search takes a shortcut over several jump points, and looks for a goal from each of them if the shortcut
// may see one. The jumps come from ScannedJumps, or from KnownJumps on a map that was prepared. Open states
// lie in buckets that are not sorted exactly, so a state may be expanded again when a cheaper path to it is
// found. The search ends when the current bucket is past the cost of the cheapest path found.
//
// Optimal. One thread per search.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/bucket_queue.hpp"
#include "wend/base/limits.hpp"
#include "wend/base/state_id.hpp"
#include "wend/planner/jump/goal_sight.hpp"
#include "wend/planner/jump/jump_trail.hpp"
#include "wend/planner/jump/watched_jumps.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

template <class Jumps>
class JumpPointSearch {
 public:
  using Cost = typename Jumps::Cost;
  using Units = OctileUnits<Cost>;

  explicit JumpPointSearch(Jumps jumps) : jumps_(std::move(jumps)) {
    const std::uint64_t steps = static_cast<std::uint64_t>(jumps_.ground().width()) +
                                static_cast<std::uint64_t>(jumps_.ground().height());
    too_wide_ = steps > kInfinite / 2 / Units::kStraight;
  }

  const Jumps& jumps() const { return jumps_; }
  /// To change them between two searches.
  Jumps& jumps() { return jumps_; }

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
  std::uint64_t for_each_open(std::size_t most, Visit&& visit) const {
    if (outcome_ != SearchOutcome::running) return 0;
    return visit_open_jumps(jumps_, queue_, goals_, least_f_, seer_.node, most, visit);
  }

  /// The estimate to the nearest goal of the search begun last, in units.
  Cost h(Cell cell) const { return goals_.h(cell); }

 private:
  static constexpr Cost kInfinite = GoalSight<Cost>::kInfinite;

  using View = typename GoalSight<Cost>::View;
  using Jump = typename Jumps::Jump;
  using Shortcut = typename Jumps::Shortcut;
  using Node = typename Jumps::Node;

  /// A state that sees a goal: a node, or a jump point on a shortcut from a node.
  struct Seer {
    StateId node = 0;
    bool on_shortcut = false;
    Jump first{};  // of the shortcut
    Cell cell{};   // of the jump point
  };

  /// The state being expanded.
  struct Origin {
    StateId id;
    Cell cell;
    Cost g;
  };

  View look(Cell from, DirectionSet directions, Cost g) {
    return goals_.look(jumps_, from, directions, g);
  }
  bool look_from_passed(const Shortcut& shortcut, const Origin& from);

  /// What is in sight, but not behind a jump point, from which it is in sight as well.
  struct NearSight {
    Jumps& jumps;
    bool sees(Cell from, Cell to) const {
      return jumps.sees(from, to) && !jumps.passes_jump(from, to);
    }
  };

  struct Entry {
    Cost f;
    StateId id;
  };

  template <class Watcher>
  void expand(StateId id, Watcher& watcher);
  template <class Watcher>
  void expand_start(Watcher& watcher);
  template <class Watcher>
  void finish(Watcher& watcher);
  template <class Watcher>
  [[gnu::always_inline]] inline void reach(const Shortcut& shortcut, const Origin& from,
                                           Watcher& watcher);

  Jumps jumps_;
  BucketQueue<Entry> queue_;  // by f - least_f_
  Cost least_f_ = 0;          // that of the start
  GoalSight<Cost> goals_;
  Seer seer_;  // of the cheapest goal
  StateId start_ = 0;
  bool too_wide_;  // for an octile distance to be surely below half of kInfinite

  bool overflown_ = false;

  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
  std::uint64_t most_expansions_ = 0;
  LimitCheck limits_;
  JumpTrail trail_;
};

template <class Jumps>
template <class Watcher>
void JumpPointSearch<Jumps>::begin(Cell start, std::span<const GoalRegion> goals,
                                   const Limits& limits, Watcher&& watcher) {
  // A bucket is nearly a straight step wide.
  constexpr auto kWidthBits = static_cast<unsigned>(std::bit_width(Units::kStraight) - 1);
  limits_.begin(limits);
  most_expansions_ = limits.expansions;
  metrics_ = {.expanded = 0, .generated = 1, .max_frontier = 1};
  overflown_ = false;
  outcome_ = too_wide_ ? SearchOutcome::cost_overflow : SearchOutcome::running;
  seer_ = {};
  goals_.begin(goals, start, jumps_.ground());
  start_ = jumps_.begin(start, goals_.cells());
  queue_.begin(0, kWidthBits);
  least_f_ = h(start);
  Node& node = jumps_.node(start_);
  node.stamp = jumps_.stamp(0);
  node.cell = start;
  node.parent = start_;
  node.pending = 1;
  queue_.push(0, {least_f_, start_});
  watcher.on_generate(start, start, Cost{0});
}

template <class Jumps>
template <class Watcher>
void JumpPointSearch<Jumps>::step(Watcher&& watcher) {
  while (!queue_.empty()) {
    const auto entry = queue_.pop();
    if (queue_.least_key() > goals_.best() - least_f_) break;
    // It was reached more cheaply or expanded since then.
    if (entry.f >= goals_.best() || jumps_.node(entry.id).pending == 0) continue;
    if (limits_.due(metrics_.expanded)) {
      outcome_ = limits_.look(metrics_.expanded);
      if (outcome_ != SearchOutcome::running) return;
    }
    ++metrics_.expanded;
    if (entry.id == start_) {
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

template <class Jumps>
template <class Watcher>
void JumpPointSearch<Jumps>::finish(Watcher& watcher) {
  if (goals_.best() == kInfinite) {
    outcome_ = SearchOutcome::exhausted;
    return;
  }
  const Cell from = jumps_.node(seer_.node).cell;
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

template <class Jumps>
template <class Watcher>
void JumpPointSearch<Jumps>::expand_start(Watcher& watcher) {
  constexpr DirectionSet kEveryDirection = 0xFF;
  Node& start = jumps_.node(start_);
  start.pending = 0;
  const Origin origin{start_, start.cell, 0};
  watcher.on_expand(origin.cell, origin.cell, Cost{0});
  const View view = look(origin.cell, kEveryDirection, 0);
  if (view.better) seer_ = {.node = start_};
  if (view.nearest) return;
  jumps_.visit_first(origin.cell,
                     [&](const Shortcut& shortcut) { reach(shortcut, origin, watcher); });
}

template <class Jumps>
template <class Watcher>
void JumpPointSearch<Jumps>::expand(StateId id, Watcher& watcher) {
  Node& node = jumps_.node(id);
  const Origin origin{id, node.cell, node.g()};
  watcher.on_expand(origin.cell, jumps_.node(node.parent).cell, origin.g);
  const unsigned arrivals = std::exchange(node.pending, std::uint8_t{0});
  node.done |= static_cast<std::uint8_t>(arrivals);
  const auto for_each_arrival = [&](auto&& visit) {
    for (unsigned rest = arrivals; rest != 0; rest &= rest - 1) {
      visit(static_cast<unsigned>(std::countr_zero(rest)));
    }
  };
  DirectionSet directions = 0;
  for_each_arrival([&](unsigned arrival) { directions |= jumps_.directions(id, arrival); });
  const View view = look(origin.cell, directions, origin.g);
  if (view.better) seer_ = {.node = id};
  if (view.nearest) return;
  for_each_arrival([&](unsigned arrival) {
    jumps_.visit_shortcuts(id, arrival,
                           [&](const Shortcut& shortcut) { reach(shortcut, origin, watcher); });
  });
}

template <class Jumps>
template <class Watcher>
inline void JumpPointSearch<Jumps>::reach(const Shortcut& shortcut, const Origin& from,
                                          Watcher& watcher) {
  if (jumps_.may_see_goal(shortcut) && look_from_passed(shortcut, from)) return;
  if (shortcut.dead()) return;
  const StateId id = jumps_.end(shortcut);
  Node& node = jumps_.node(id);
  const Cost g = from.g + Jumps::cost(shortcut, from.cell, node);
  const auto stamp = jumps_.stamp(g);
  if (stamp > node.stamp) return;
  if (stamp < node.stamp && !jumps_.useful(node)) return;
  // No branch: what earlier searches left in a node is hard to predict.
  const bool open = jumps_.reached(node) & (node.pending != 0);
  const auto arrival = static_cast<std::uint8_t>(1U << Jumps::arrival(shortcut));
  if (stamp < node.stamp) {
    node.stamp = stamp;
    node.parent = from.id;
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
  if (g < from.g || f < g || f == kInfinite) {  // more than the type holds
    overflown_ = true;
    return;
  }
  jumps_.prefetch(shortcut);
  queue_.push(f - least_f_, {f, id});
}

/// Looks for goals from the jump points that a shortcut passes, and from its end if that has no
/// successor. True if no path that continues is shorter. Where a search looks does not depend on what is
/// known of the map.
template <class Jumps>
bool JumpPointSearch<Jumps>::look_from_passed(const Shortcut& shortcut, const Origin& from) {
  Cell at = from.cell;
  Cost g = from.g;
  return jumps_.visit_passed(shortcut, [&](Jump /*jump*/, Cell cell, DirectionSet directions) {
    const Cost reached = g + octile_cost<Cost>(std::exchange(at, cell), cell);
    if (reached < g) {  // more than the type holds
      overflown_ = true;
      return true;
    }
    g = reached;
    const View view = goals_.look(NearSight{jumps_}, cell, directions, g);
    if (view.better) seer_ = {from.id, true, shortcut.first(), cell};
    return view.nearest;
  });
}

template <class Jumps>
std::span<const Cell> JumpPointSearch<Jumps>::waypoints() {
  trail_.begin(goals_.goal());
  if (seer_.on_shortcut) jumps_.append_back(trail_, seer_.first, seer_.cell);
  for (StateId id = seer_.node; id != start_; id = jumps_.node(id).parent) {
    jumps_.append_back(trail_, jumps_.node(id).first, jumps_.node(id).cell);
  }
  trail_.append(jumps_.node(start_).cell);
  return trail_.from_start();
}

}  // namespace wend
