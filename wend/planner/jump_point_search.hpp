#pragma once

// JumpPointSearch: A* that jumps from one jump point to the next and leaves out what lies between.
//
//   auto boards = std::make_shared<const wend::JumpBoards>(wend::drawn_passable(space));
//   wend::JumpPointSearch<std::uint32_t> search(boards);
//   search.begin({1, 1}, goals, limits);
//   if (search.run() == wend::SearchOutcome::found) draw(search.waypoints());
//
// A state is a jump point together with the straight directions it was reached in, all by equally
// cheap ways. It is expanded into those directions, and past obstacles into the forced ones: a
// diagonal run sends out straight ones along its way and opens the jump points that they end on;
// cells where it turns are never opened. A state that sees a goal opens nothing: no way is
// shorter. Open states lie in buckets whose order is inexact, so a state may be expanded again when a cheaper
// way to it comes, and the search ends when the bucket in work is past the cheapest way found.
//
// Optimal. 16 bytes a cell (24 with costs in 64 bits), touched only where the search goes, and the
// boards. One thread a search; boards are shared.

#include <algorithm>
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
#include "wend/planner/jump_queue.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/search_metrics.hpp"
#include "wend/space/dead_ends.hpp"
#include "wend/space/jump_boards.hpp"
#include "wend/space/octile_units.hpp"

namespace wend {

/// Watches nothing, and costs nothing.
struct NoJumpWatcher {
  void on_generate(Cell, Cell, auto) const {}
  void on_expand(Cell, Cell, auto) const {}
  void on_relax(Cell, Cell, auto) const {}
};

template <class CostType,
          std::uint32_t kLastGeneration = std::numeric_limits<std::uint32_t>::max() / 2>
class JumpPointSearch {
 public:
  using Cost = CostType;
  using Units = OctileUnits<Cost>;

  JumpPointSearch(std::shared_ptr<const JumpBoards> boards,
                  std::shared_ptr<const DeadEnds> dead_ends)
      : boards_(std::move(boards)),
        open_(std::move(dead_ends)),
        row_bits_(std::bit_width(static_cast<unsigned>(boards_->width() - 1))),
        nodes_(static_cast<Node*>(std::calloc(node_count(), sizeof(Node)))) {}

  /// False if there was no memory: every search ends as out_of_memory.
  bool allocated() const { return nodes_ != nullptr; }

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
    Cost least = std::numeric_limits<Cost>::max();
    for (const Cell goal : goals_) least = std::min(least, octile(cell, goal));
    return least;
  }

 private:
  // A start has been reached in every direction, other states in straight ones.
  static constexpr DirectionSet kEveryDirection = 0xFF;
  static constexpr DirectionSet kDiagonals = 0xAA;

  struct Node {
    Cost g;
    StateId parent;
    std::uint32_t generation : 31;  // of the search that reached it; 0: never
    std::uint32_t in_dead_end : 1;  // of the map, not of a search
    DirectionSet pending;           // arrivals to be expanded
    DirectionSet done;              // arrivals that were, as cheaply
    DirectionSet useful;            // where there is something; of the map, not of a search
    std::uint8_t forced;  // by arrival d: bit d if one turns by +90 degrees, d + 1 by -90; likewise
  };

  struct Free {
    void operator()(Node* nodes) const { std::free(nodes); }
  };

  static Cost octile(Cell from, Cell to) {
    const auto dx = static_cast<Cost>(std::abs(to.x - from.x));
    const auto dy = static_cast<Cost>(std::abs(to.y - from.y));
    return Units::kStraight * std::max(dx, dy) +
           (Units::kDiagonal - Units::kStraight) * std::min(dx, dy);
  }

  std::size_t node_count() const {
    return static_cast<std::size_t>(boards_->height()) << row_bits_;
  }
  StateId id_of(Cell cell) const {
    return static_cast<StateId>(cell.y) << row_bits_ | static_cast<StateId>(cell.x);
  }
  Cell cell_of(StateId id) const {
    return {static_cast<int>(id & ((StateId{1} << row_bits_) - 1)),
            static_cast<int>(id >> row_bits_)};
  }

  void next_generation();
  void learn(Node& node, Cell cell) const;
  DirectionSet successors(const Node& node) const;
  bool within_limits();
  bool see_goal(Cell cell, const Node& node, StateId id);

  template <class Watcher>
  void expand(StateId id, Node& node, Watcher& watcher);
  template <class Watcher>
  void finish(Watcher& watcher);
  template <Direction kStraight, class Watcher>
  void shoot(Cell from, std::uint64_t g, StateId parent, Watcher& watcher);
  template <Direction kDiagonal, class Watcher>
  void sweep(Cell from, std::uint64_t g, StateId parent, Watcher& watcher);
  template <class Watcher>
  void reach(Cell cell, std::uint64_t g, StateId parent, DirectionSet arrival, Watcher& watcher);

  std::shared_ptr<const JumpBoards> boards_;
  OpenDeadEnds open_;
  int row_bits_;  // of an id that tell the column
  std::unique_ptr<Node[], Free> nodes_;
  std::uint32_t generation_ = 0;
  JumpQueue<Cost> queue_;
  std::vector<Cell> goals_;

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

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::begin(Cell start, std::span<const Cell> goals,
                                         const Limits& limits, Watcher&& watcher) {
  // A bucket is nearly a straight step wide.
  constexpr auto kWidthBits = static_cast<unsigned>(std::bit_width(Units::kStraight) - 1);
  limits_ = &limits;
  deadline_ = limits.clock ? limits.clock() + limits.seconds : 0;
  next_check_ = 0;
  metrics_ = {};
  overflown_ = false;
  best_ = std::numeric_limits<Cost>::max();
  outcome_ = allocated() ? SearchOutcome::running : SearchOutcome::out_of_memory;
  if (!allocated()) return;
  next_generation();
  goals_.assign(goals.begin(), goals.end());
  open_.open_for(start, goals);
  queue_.begin(h(start), kWidthBits);
  reach(start, 0, id_of(start), kEveryDirection, watcher);
}

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::step(Watcher&& watcher) {
  while (!queue_.empty()) {
    const auto entry = queue_.pop();
    if (queue_.bucket_is_behind(best_)) break;
    Node& node = nodes_[entry.id];
    if (entry.f >= best_ || node.pending == 0) continue;  // of no use, or expanded meanwhile
    if (metrics_.expanded == next_check_ && !within_limits()) return;
    expand(entry.id, node, watcher);
    if (overflown_) outcome_ = SearchOutcome::cost_overflow;
    return;
  }
  finish(watcher);
}

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::finish(Watcher& watcher) {
  if (best_ == std::numeric_limits<Cost>::max()) {
    outcome_ = SearchOutcome::exhausted;
    return;
  }
  outcome_ = SearchOutcome::found;
  const Cell from = cell_of(seen_from_);
  if (from == goal_) return;  // expanded before
  ++metrics_.generated;
  ++metrics_.expanded;
  watcher.on_generate(goal_, from, best_);
  watcher.on_expand(goal_, from, best_);
}

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::expand(StateId id, Node& node, Watcher& watcher) {
  using enum Direction;
  ++metrics_.expanded;
  const Cell cell = cell_of(id);
  watcher.on_expand(cell, cell_of(node.parent), node.g);
  const DirectionSet directions = successors(node);
  node.done |= node.pending;
  node.pending = 0;
  if (see_goal(cell, node, id)) return;
  const std::uint64_t g = node.g;
  if ((directions & set_of(down)) != 0) shoot<down>(cell, g, id, watcher);
  if ((directions & set_of(right)) != 0) shoot<right>(cell, g, id, watcher);
  if ((directions & set_of(up)) != 0) shoot<up>(cell, g, id, watcher);
  if ((directions & set_of(left)) != 0) shoot<left>(cell, g, id, watcher);
  if ((directions & kDiagonals) == 0) return;
  if ((directions & set_of(down_right)) != 0) sweep<down_right>(cell, g, id, watcher);
  if ((directions & set_of(up_right)) != 0) sweep<up_right>(cell, g, id, watcher);
  if ((directions & set_of(up_left)) != 0) sweep<up_left>(cell, g, id, watcher);
  if ((directions & set_of(down_left)) != 0) sweep<down_left>(cell, g, id, watcher);
}

template <class Cost, std::uint32_t kLast>
template <Direction kStraight, class Watcher>
void JumpPointSearch<Cost, kLast>::shoot(Cell from, std::uint64_t g, StateId parent,
                                         Watcher& watcher) {
  const int distance = boards_->template distance_to_stop<kStraight>(from);
  reach(moved(from, kStraight, distance),
        g + std::uint64_t{Units::kStraight} * static_cast<unsigned>(distance), parent,
        set_of(kStraight), watcher);
}

template <class Cost, std::uint32_t kLast>
template <Direction kDiagonal, class Watcher>
void JumpPointSearch<Cost, kLast>::sweep(Cell from, std::uint64_t g, StateId parent,
                                         Watcher& watcher) {
  constexpr Direction kOne = turned(kDiagonal, -1);
  constexpr Direction kOther = turned(kDiagonal, 1);
  Cell at = from;
  do {
    const int distance = boards_->template distance_to_diagonal_stop<kDiagonal>(at);
    at = moved(at, kDiagonal, distance);
    g += std::uint64_t{Units::kDiagonal} * static_cast<unsigned>(distance);
    const DirectionSet rays = boards_->rays(at);
    if ((rays & set_of(kOne)) != 0) shoot<kOne>(at, g, parent, watcher);
    if ((rays & set_of(kOther)) != 0) shoot<kOther>(at, g, parent, watcher);
  } while ((boards_->diagonals(at) & set_of(kDiagonal)) != 0);
}

template <class Cost, std::uint32_t kLast>
template <class Watcher>
void JumpPointSearch<Cost, kLast>::reach(Cell cell, std::uint64_t g, StateId parent,
                                         DirectionSet arrival, Watcher& watcher) {
  const StateId id = id_of(cell);
  Node& node = nodes_[id];
  if (node.generation != generation_ || g < node.g) {
    if (node.generation == 0) learn(node, cell);
    if (node.in_dead_end != 0 && !open_.contains(cell)) return;
    const bool open = node.generation == generation_ && node.pending != 0;
    node.g = static_cast<Cost>(g);
    node.parent = parent;
    node.generation = generation_;
    node.pending = arrival;
    node.done = 0;
    if (open) {
      watcher.on_relax(cell, cell_of(parent), node.g);
    } else {
      ++metrics_.generated;
      watcher.on_generate(cell, cell_of(parent), node.g);
    }
  } else {
    // A new direction counts where the way is as cheap.
    if (g > node.g || (arrival & ~(node.pending | node.done)) == 0) return;
    const bool open = node.pending != 0;
    node.pending |= arrival;
    if (open) return;
    ++metrics_.generated;
    watcher.on_generate(cell, cell_of(parent), node.g);
  }
  const std::uint64_t f = g + h(cell);
  if (f >= std::numeric_limits<Cost>::max()) {
    overflown_ = true;
    return;
  }
  queue_.push(static_cast<Cost>(f), id);
  metrics_.max_frontier = std::max(metrics_.max_frontier, metrics_.generated - metrics_.expanded);
}

/// What is true of a cell in every search: where there is anything to find, and which way obstacles
/// make one turn.
template <class Cost, std::uint32_t kLast>
void JumpPointSearch<Cost, kLast>::learn(Node& node, Cell cell) const {
  node.useful = boards_->rays(cell) | boards_->diagonals(cell);
  node.in_dead_end = open_.in_core(cell) ? 0 : 1;
  node.forced = 0;
  for (const Direction arrival :
       {Direction::down, Direction::right, Direction::up, Direction::left}) {
    const Cell last = moved(cell, arrival, -1);
    if (!boards_->passable(last)) continue;
    for (const int eighths : {2, -2}) {
      const Direction side = turned(arrival, eighths);
      const bool forced =
          boards_->passable(moved(cell, side, 1)) && !boards_->passable(moved(last, side, 1));
      if (!forced) continue;
      node.forced |= static_cast<std::uint8_t>(set_of(arrival) << (eighths > 0 ? 0U : 1U));
    }
  }
}

/// Straight on, and to the forced sides.
template <class Cost, std::uint32_t kLast>
DirectionSet JumpPointSearch<Cost, kLast>::successors(const Node& node) const {
  constexpr DirectionSet kPlus =
      set_of(turned(Direction::down, 1)) | set_of(turned(Direction::down, 2));
  constexpr DirectionSet kMinus =
      set_of(turned(Direction::down, -1)) | set_of(turned(Direction::down, -2));
  if ((node.pending & kDiagonals) != 0) return node.useful;  // the start
  DirectionSet set = node.pending;
  for (unsigned arrivals = node.pending; arrivals != 0; arrivals &= arrivals - 1) {
    const int arrival = std::countr_zero(arrivals);
    const unsigned forced = static_cast<unsigned>(node.forced) >> arrival;
    if ((forced & 1U) != 0) set |= std::rotl(kPlus, arrival);
    if ((forced & 2U) != 0) set |= std::rotl(kMinus, arrival);
  }
  return set & node.useful;
}

/// Is the nearest goal in sight? Then no way from here is shorter than the straight one to it.
template <class Cost, std::uint32_t kLast>
bool JumpPointSearch<Cost, kLast>::see_goal(Cell cell, const Node& node, StateId id) {
  bool seen_nearest = false;
  const Cost nearest = h(cell);
  for (const Cell goal : goals_) {
    const Cost distance = octile(cell, goal);
    if (!boards_->in_sight(cell, goal)) continue;
    seen_nearest = seen_nearest || distance == nearest;
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
    for (std::size_t id = 0; id < node_count(); ++id) {
      nodes_[id].generation = std::min<std::uint32_t>(nodes_[id].generation, 1);
    }
    generation_ = 1;
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
    const Cell from = cell_of(id);
    const int right = to.x - from.x;
    const int down = to.y - from.y;
    const int diagonal = std::min(std::abs(right), std::abs(down));
    const Cell turn{from.x + (right < 0 ? -diagonal : diagonal),
                    from.y + (down < 0 ? -diagonal : diagonal)};
    if (turn != to && turn != from) waypoints_.push_back(turn);
    if (from != to) waypoints_.push_back(from);
    if (nodes_[id].parent == id) break;
    to = from;
  }
  std::reverse(waypoints_.begin(), waypoints_.end());
  return waypoints_;
}

}  // namespace wend
