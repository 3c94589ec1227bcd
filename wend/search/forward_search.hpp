#pragma once

// ForwardSearch: LaValle's general forward search ("Planning Algorithms", 2006, section 2.2). Take
// a state from the frontier, expand it, resolve duplicates, repeat. Each classic planner is a
// choice of its components.
//
//   using BreadthFirst = ForwardSearch<ExactGrid, FifoFrontier, ByArrival, DuplicateRule::keep_first>;
//   BreadthFirst search(space, priority);
//   search.begin(starts, limits);
//   while (search.outcome() == SearchOutcome::running) search.step();
//
// A goal is recognised when it is expanded. Closed states are never reopened: with keep_cheaper the
// answer is optimal if keys never decrease along a path (a consistent heuristic). Nothing is allocated
// once the frontier has its final size. O(states) memory, touched only where the search goes.
//
// With in_rounds it is the anytime search ARA*, whose rounds reopen states and leave out those that cannot improve
// its path: rounds.hpp.
//
// Links are how a state is reached, and what its node keeps of that: StepLinks, by a move from the state
// that is expanded, or a choice of parents (links.hpp). The Store keeps the nodes: DenseNodes, one for each
// state; PagedNodes for spaces of which a search needs a small part.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <unordered_set>
#include <utility>

#include "wend/base/limits.hpp"
#include "wend/search/concepts.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/links.hpp"
#include "wend/search/node_table.hpp"
#include "wend/search/rounds.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// What to do with a state that is reached again before it is expanded. With keep_first, a priority with
/// replaces(g, before) may say that the new way is as good by its order, and better otherwise: the state keeps its
/// place in the frontier.
enum class DuplicateRule { keep_first, keep_cheaper, in_rounds };

template <SearchSpace Space, SearchFrontier Frontier, SearchPriority<Space> Priority,
          DuplicateRule kDuplicates, class Links = StepLinks,
          template <class> class Store = DenseNodes>
class ForwardSearch {
 public:
  using SpaceType = Space;
  using State = typename Space::State;
  using Cost = typename Space::Cost;
  using Key = typename Frontier::Key;
  static constexpr bool kInRounds = kDuplicates == DuplicateRule::in_rounds;
  using LinkNode = typename Links::template Node<Cost>;
  using Node = std::conditional_t<kInRounds, AnytimeNode<LinkNode>, LinkNode>;
  using Arrival = typename Node::Arrival;
  static constexpr Arrival kNoArrival = Node::kNoArrival;

  ForwardSearch(Space space, Priority priority)
    requires(!kInRounds)
      : space_(std::move(space)), priority_(std::move(priority)), nodes_(space_.state_count()) {}
  ForwardSearch(Space space, Priority priority, AnytimeWeights weights)
    requires kInRounds
      : space_(std::move(space)),
        priority_(std::move(priority)),
        nodes_(space_.state_count()),
        rounds_(weights) {}

  /// False if there was no memory for the nodes. Then every search ends as out_of_memory.
  bool allocated() const { return nodes_.allocated(); }

  const Space& space() const { return space_; }
  Space& space() { return space_; }
  Priority& priority() { return priority_; }
  const Priority& priority() const { return priority_; }
  const SearchMetrics& metrics() const { return metrics_; }
  SearchOutcome outcome() const { return outcome_; }

  /// Forgets the last search and opens the starts, in rounds one. `limits` must live as long as the search.
  template <class Observer = NoObserver>
  void begin(std::span<const State> starts, const Limits& limits, Observer&& observer = {}) {
    limits_.begin(limits);
    metrics_ = {};
    outcome_ = allocated() ? SearchOutcome::running : SearchOutcome::out_of_memory;
    if (!allocated()) return;
    nodes_.begin_search();
    frontier_.clear();
    if constexpr (kInRounds) rounds_.begin(*this, starts.front());
    for (const State& start : starts) reach(start, Cost{0}, kNoArrival, observer);
    metrics_.max_frontier = metrics_.generated;
  }

  /// Steps until there is an outcome; after `improved`, until there is the next one.
  template <class Observer = NoObserver>
  SearchOutcome run(Observer&& observer = {}) {
    if (outcome_ == SearchOutcome::improved) outcome_ = SearchOutcome::running;
    if (outcome_ == SearchOutcome::running) advance(false, observer);
    return outcome_;
  }

  /// Expands one state.
  template <class Observer = NoObserver>
  void step(Observer&& observer = {}) {
    if constexpr (kInRounds) outcome_ = SearchOutcome::running;
    advance(true, observer);
  }

  /// The state whose expansion ended the search as found; in rounds, the end of the path.
  const State& goal() const { return goal_; }
  /// In rounds: the path costs at most this times the least.
  double bound() const
    requires kInRounds
  {
    return rounds_.bound();
  }

  /// Was the state reached, and how? g is final once it is closed.
  bool reached(StateId id) const { return nodes_.reached(nodes_[id]); }
  bool closed(StateId id) const {
    const Node& node = nodes_[id];
    return nodes_.reached(node) && is_closed(node);
  }
  Cost g(StateId id) const { return nodes_[id].g; }
  Arrival arrival(StateId id) const { return nodes_[id].arrival(); }

  /// The state from which a state was reached; `arrival` is not kNoArrival.
  State parent(const State& state, Arrival arrival) const {
    if constexpr (kByMoves) {
      return space_.parent(state, arrival);
    } else {
      return space_.state(arrival);
    }
  }

  /// How many states are open.
  std::uint64_t open_count() const {
    if constexpr (kInRounds) {
      return rounds_.due_count();
    } else {
      return metrics_.generated - metrics_.expanded;
    }
  }

  /// Calls visit(state, key) for the states that would be expanded next, in that order, at most
  /// `most` of them. Takes them from a copy of the frontier: O(entries of the frontier).
  template <class Visit>
  void for_each_open(std::size_t most, Visit&& visit) const {
    Frontier rest = frontier_;
    std::unordered_set<StateId> visited;  // older entries of a state are skipped
    while (visited.size() < most && !rest.empty()) {
      const auto entry = rest.pop();
      if (closed(entry.id) || !visited.insert(entry.id).second) continue;
      visit(space_.state(entry.id), entry.key);
    }
  }

  /// Calls visit(state) for every state from `last` back to the start.
  template <class Visit>
  void for_each_back_from(State last, Visit&& visit) const {
    visit(last);
    for (Arrival by = arrival(space_.id(last)); by != kNoArrival; by = arrival(space_.id(last))) {
      last = parent(last, by);
      visit(last);
    }
  }

 private:
  friend class Rounds<Cost>;
  struct NoRounds {};
  using Nodes = Store<Node>;
  static constexpr bool kByMoves = std::is_same_v<Arrival, Move>;

  bool is_closed(const Node& node) const {
    if constexpr (kInRounds) {
      return rounds_.closed(node);
    } else {
      return node.closed();
    }
  }

  void close(Node& node) {
    if constexpr (kInRounds) {
      rounds_.close(node);
    } else {
      node.close();
    }
  }

  /// Expands one state, or states until there is an outcome. One function, so that the loop is compiled once.
  template <class Observer>
  void advance(bool once, Observer&& observer) {
    do {
      if (frontier_.empty()) {
        outcome_ = SearchOutcome::exhausted;
        return;
      }
      const auto entry = frontier_.pop();
      auto& node = nodes_[entry.id];
      if (!kInRounds && node.closed()) continue;  // was expanded with a smaller key
      if (is_check_due() && !within_limits(entry, observer)) return;
      close(node);
      expand(space_.state(entry.id), node, observer);
      if constexpr (kInRounds) {
        if (outcome_ == SearchOutcome::running) rounds_.settle(*this, observer);
      }
      if (once) return;
    } while (outcome_ == SearchOutcome::running);
  }

  Key key_of(StateId id) const { return priority_.key(space_.state(id), nodes_[id].g); }

  template <class Observer>
  void expand(const State& state, Node& node, Observer&& observer) {
    ++metrics_.expanded;
    if constexpr (requires { Links::settled(*this, state); }) {
      if (const auto link = Links::settled(*this, state)) node.replace(link->g, link->parent);
    }
    const Cost g = node.g;
    const Arrival arrival = node.arrival();
    observer.on_expand(state, arrival, g);
    if (priority_.is_goal(state)) {
      if constexpr (kInRounds) return;
      goal_ = state;
      outcome_ = SearchOutcome::found;
      return;
    }
    const Move move_here = move_of(arrival);
    space_.for_each_successor(state, move_here, [&](const State& next, Move move, Cost step_cost) {
      if (!reach_from(state, g, next, move, step_cost, observer)) return;
      if constexpr (requires { space_.ahead(state, next); }) {
        nodes_.prefetch(space_.ahead(state, next));
      }
    });
    note_frontier();
  }

  void note_frontier() {
    std::uint64_t open = metrics_.generated - metrics_.expanded;
    if constexpr (kInRounds) open = rounds_.open_count();
    metrics_.max_frontier = std::max(metrics_.max_frontier, open);
  }

  /// For a space that leaves out what is reached as cheaply by another path. In rounds there may be none: that
  /// path was left out where it cannot improve the one found.
  static Move move_of(Arrival arrival) {
    if constexpr (kByMoves && !kInRounds) {
      return arrival;
    } else {
      return kNoMove;
    }
  }

  /// Opens a successor of a state by the link that the Links choose; returns whether it did.
  template <class Observer>
  bool reach_from(const State& state, Cost g, const State& next, Move move, Cost step_cost,
                  Observer&& observer) {
    if constexpr (kByMoves) {
      return reach(next, static_cast<Cost>(g + step_cost), move, observer);
    } else {
      if (!kInRounds && closed(space_.id(next))) return false;
      const auto link = Links::link(*this, state, next, step_cost);
      return link && reach(next, link->g, link->parent, observer);
    }
  }

  /// Opens a state unless it was reached as well or better; returns whether it did.
  template <class Observer>
  bool reach(const State& next, Cost g, Arrival arrival, Observer&& observer) {
    Node* const room = nodes_.room_for(space_.id(next));
    if constexpr (Nodes::kGrows) {
      if (room == nullptr) {
        outcome_ = SearchOutcome::out_of_memory;
        return false;
      }
    }
    Node& node = *room;
    const bool again = nodes_.reached(node);
    if constexpr (kInRounds) {
      if ((again && !(g < node.g)) || rounds_.prunes(*this, next, g)) return false;
      if (!again) node.begin();
    }
    if (!again) {
      ++metrics_.generated;
      nodes_.open(node, g, arrival);
      observer.on_generate(next, arrival, g);
    } else {
      if constexpr (kDuplicates == DuplicateRule::keep_first) {
        if constexpr (requires { priority_.replaces(g, node.g); }) {
          if (node.closed() || !priority_.replaces(g, node.g)) return false;
          nodes_.open(node, g, arrival);
          observer.on_relax(next, arrival, g);
        }
        return false;
      }
      if (!kInRounds && (node.closed() || !(g < node.g))) return false;
      nodes_.open(node, g, arrival);
      observer.on_relax(next, arrival, g);
    }
    if constexpr (kInRounds) {
      rounds_.reached(*this, next, space_.id(next), node);
    } else {
      frontier_.push(priority_.key(next, g), space_.id(next));
    }
    return true;
  }

  bool is_check_due() const {
    if constexpr (kInRounds) {
      if (priority_.stopped()) return true;
    }
    return limits_.due(metrics_.expanded);
  }

  /// Checks everything that may end the search early, before an entry of the frontier is expanded.
  bool within_limits(const auto& entry, auto&& observer) {
    outcome_ = limits_.look(metrics_.expanded);
    if constexpr (kInRounds) {
      if (outcome_ == SearchOutcome::running) outcome_ = priority_.stopped().value_or(outcome_);
    }
    if (outcome_ == SearchOutcome::running && priority_.near_overflow(entry.key)) {
      outcome_ = SearchOutcome::cost_overflow;
    }
    if (outcome_ == SearchOutcome::running) return true;
    if constexpr (kInRounds) {
      frontier_.push(entry.key, entry.id);
      rounds_.limit(*this, observer);
    }
    return false;
  }

  Space space_;
  Priority priority_;
  Nodes nodes_;
  Frontier frontier_;
  [[no_unique_address]] std::conditional_t<kInRounds, Rounds<Cost>, NoRounds> rounds_;
  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
  State goal_{};
  LimitCheck limits_;
};

}  // namespace wend
