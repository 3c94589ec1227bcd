#pragma once

// AnytimeSearch: ARA*, a best-first search that finds a path soon and better ones as long as it may go on.
// M. Likhachev, G. Gordon and S. Thrun, "ARA*: Anytime A* with Provable Bounds on Sub-Optimality", 2003.
// Each call of run() after begin() ends with SearchOutcome::improved at a better path, until the best one is proven.
//
// Each round is a weighted A*, f = g + w h, that expands a state at most once; a state that is reached more
// cheaply after that waits for the next round. A round ends when no open state has an f below the cost of the
// path. The next one takes a smaller weight and only the states that waited or are still open, until the last
// weight; after 1 the path is optimal.
//
// What is proven: let L be the least g + h of the states that are open or wait. No path costs less than L, nor
// less than the cost of the path at the end of a round over w. The bound is the cost over the larger of the two,
// so it never rises, also where a limit ends a round early. States whose g + h is not below the cost of the path
// are left out, which changes neither. When a round ends, the costs along the path are summed again: some of its
// states may have become cheaper since their successors were reached.
//
// h must be consistent. One that a limit cut off (stopped()) is still at most the cost to go, so the sums g + h
// prove what they prove, but the end of a round does not.
//
// One search for robots on cells (ara_star) and on lattices (the option initial_weight of lattice and car): it
// knows only a space and a priority. Planners of poses got an option, not a second name: their motions, costs
// and heuristics stay in one place, and with an initial weight of 1 ARA* is the A* that they are.
//
// Parts are those of a ForwardSearch, but the priority has these functions instead:
//
//   weigh(w)          the weight of the round
//   key(state, g)     g + w h; of equal f, the larger g first. The key has f and g.
//   total(state, g)   g + h, at most the cost of a path through the state
//   stopped()         the outcome of an h that was cut off

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/search/anytime_node.hpp"
#include "wend/search/concepts.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/links.hpp"
#include "wend/search/min_heap.hpp"
#include "wend/search/node_table.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// The weights of the rounds: the first one, what is subtracted from the smaller of weight and bound, and the last.
struct AnytimeWeights {
  double first;
  double step;      // above 0
  double last = 1;  // from 1 to `first`
};

template <SearchSpace Space, class Priority, class Links = StepLinks,
          template <class> class Store = DenseNodes>
class AnytimeSearch {
 public:
  using SpaceType = Space;
  using State = typename Space::State;
  using Cost = typename Space::Cost;
  using Key = typename Priority::Key;
  using Node = AnytimeNode<typename Links::template Node<Cost>>;
  using Arrival = typename Node::Arrival;
  static constexpr Arrival kNoArrival = Node::kNoArrival;

  AnytimeSearch(Space space, Priority priority, AnytimeWeights weights)
      : space_(std::move(space)),
        priority_(std::move(priority)),
        weights_(weights),
        nodes_(space_.state_count()) {}

  /// False if there was no memory for the nodes. Then every search ends as out_of_memory.
  bool allocated() const { return nodes_.allocated(); }

  const Space& space() const { return space_; }
  Priority& priority() { return priority_; }
  const Priority& priority() const { return priority_; }
  const SearchMetrics& metrics() const { return metrics_; }
  SearchOutcome outcome() const { return outcome_; }

  /// Forgets the last search and opens the start. `limits` must live as long as the search.
  template <class Observer = NoObserver>
  void begin(const State& start, const Limits& limits, Observer&& observer = {}) {
    limits_.begin(limits);
    metrics_ = {};
    outcome_ = allocated() ? SearchOutcome::running : SearchOutcome::out_of_memory;
    if (!allocated()) return;
    nodes_.begin_search();
    heap_.clear();
    waiting_.clear();
    age_rank_ = UINT32_MAX;
    open_count_ = 0;
    round_ = 1;
    has_path_ = false;
    weigh(weights_.first);
    lower_ = static_cast<double>(priority_.total(start, Cost{0}));
    reach(start, Cost{0}, kNoArrival, observer);
    metrics_.max_frontier = open_count_;
  }

  /// Steps until there is a better path or bound (improved), or the search has ended.
  template <class Observer = NoObserver>
  SearchOutcome run(Observer&& observer = {}) {
    do {
      step(observer);
    } while (outcome_ == SearchOutcome::running);
    return outcome_;
  }

  /// Expands one state, of a search that is running or has improved.
  template <class Observer = NoObserver>
  void step(Observer&& observer = {}) {
    if (ended()) return;
    outcome_ = SearchOutcome::running;
    const bool due = limits_.due(metrics_.expanded) || priority_.stopped();
    if (due && !within_limits(observer)) return;
    const StateId id = min_heap::pop(heap_).id;
    expand(space_.state(id), observer);
    if (!ended()) settle(observer);
  }

  /// The end of the path, if there is one.
  const State& goal() const { return goal_; }
  /// Its cost is at most this times the least: at least 1, infinite where nothing is proven.
  double bound() const {
    const auto cost = static_cast<double>(cost_);
    if (cost <= lower_) return 1;
    return lower_ > 0 ? cost / lower_ : std::numeric_limits<double>::infinity();
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

  /// How many states this round may expand.
  std::uint64_t open_count() const { return open_count_ - waiting_.size(); }

  /// Calls visit(state, key) for the states to be expanded next, in that order, at most `most` of them. O(open
  /// states, sorted).
  template <class Visit>
  void for_each_open(std::size_t most, Visit&& visit) const {
    std::vector<Entry> rest;
    for (const Entry& entry : heap_) {
      if (is_live(entry)) rest.push_back(entry);
    }
    std::sort(rest.begin(), rest.end());
    rest.resize(std::min(most, rest.size()));
    for (const Entry& entry : rest) visit(space_.state(entry.id), entry.key);
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
  using Entry = FrontierEntry<Key>;
  static constexpr bool kByMoves = std::is_same_v<Arrival, Move>;

  bool ended() const {
    return outcome_ != SearchOutcome::running && outcome_ != SearchOutcome::improved;
  }

  void weigh(double weight) {
    weight_ = weight;
    priority_.weigh(weight);
  }

  Key key_of(StateId id) const { return priority_.key(space_.state(id), nodes_[id].g); }
  void push(StateId id, const Key& key) { min_heap::push(heap_, Entry{key, age_rank_--, id}); }

  /// Is it the last entry of a state that this round may expand?
  bool is_live(const Entry& entry) const {
    const Node& node = nodes_[entry.id];
    return node.is_open() && !node.expanded_in(round_) && !(node.g < entry.key.g);
  }

  /// Can a path through the state be cheaper than the one that was found?
  bool can_improve(const State& state, Cost g) const {
    return !has_path_ || priority_.total(state, g) < cost_;
  }

  template <class Observer>
  void expand(const State& state, Observer&& observer) {
    Node& node = nodes_[space_.id(state)];
    node.expand_in(round_);
    --open_count_;
    ++metrics_.expanded;
    const Cost g = node.g;
    const Arrival arrival = node.arrival();
    observer.on_expand(state, arrival, g);
    if (priority_.is_goal(state)) return;
    space_.for_each_successor(state, kNoMove, [&](const State& next, Move move, Cost step_cost) {
      if constexpr (kByMoves) {
        reach(next, static_cast<Cost>(g + step_cost), move, observer);
      } else {
        reach(next, static_cast<Cost>(g + step_cost), space_.id(state), observer);
      }
    });
    metrics_.max_frontier = std::max(metrics_.max_frontier, open_count_);
  }

  /// Opens a state unless it was reached as well or better, or cannot improve the path.
  template <class Observer>
  void reach(const State& next, Cost g, Arrival arrival, Observer&& observer) {
    const StateId id = space_.id(next);
    Node* const room = nodes_.room_for(id);
    if (room == nullptr) {
      outcome_ = SearchOutcome::out_of_memory;
      return;
    }
    const bool again = nodes_.reached(*room);
    if (again && !(g < room->g)) return;
    if (!can_improve(next, g)) return;
    if (!again) {
      ++metrics_.generated;
      room->begin();
    }
    nodes_.open(*room, g, arrival);
    if (again) {
      observer.on_relax(next, arrival, g);
    } else {
      observer.on_generate(next, arrival, g);
    }
    if (priority_.is_goal(next)) take_path(next, g);
    queue(id, *room, next);
  }

  void take_path(const State& end, Cost cost) {
    has_path_ = true;
    goal_ = end;
    cost_ = cost;
  }

  /// Opens a node whose g has fallen, in this round or for the next.
  void queue(StateId id, Node& node, const State& state) {
    const bool was_open = node.is_open();
    if (!was_open) {
      node.set_open(true);
      ++open_count_;
    }
    if (!node.expanded_in(round_)) {
      push(id, priority_.key(state, node.g));
    } else if (!was_open) {
      waiting_.push_back(id);
    }
  }

  /// Ends rounds until there is a state to expand, or none that could improve the path.
  template <class Observer>
  void settle(Observer&& observer) {
    for (;;) {
      while (!heap_.empty() && !is_live(heap_.front())) min_heap::pop(heap_);
      if (!heap_.empty() && is_due(heap_.front())) return;
      if (!has_path_) {
        outcome_ = SearchOutcome::exhausted;
        return;
      }
      end_round(observer);
      if (outcome_ == SearchOutcome::found) return;
    }
  }

  /// The goal comes before others of its f, so that the path's end is expanded as in A*.
  bool is_due(const Entry& entry) const {
    return !has_path_ || entry.key.f < static_cast<double>(cost_) || entry.id == space_.id(goal_);
  }

  template <class Observer>
  void end_round(Observer&& observer) {
    if (!priority_.stopped()) lower_ = std::max(lower_, static_cast<double>(cost_) / weight_);
    sum_path(observer);
    gather();
    if (weight_ <= weights_.last || bound() <= weights_.last) {
      outcome_ = SearchOutcome::found;
      return;
    }
    outcome_ = SearchOutcome::improved;
    weigh(std::max(weights_.last, std::min(weight_, bound()) - weights_.step));
    for (Entry& entry : heap_) entry.key = key_of(entry.id);
    min_heap::make(heap_);
  }

  /// Begins the next round with the states that are open or wait and can improve the path; raises the proven
  /// least cost.
  void gather() {
    std::erase_if(heap_, [this](const Entry& entry) { return !is_live(entry); });
    for (const StateId id : waiting_) heap_.push_back({{}, age_rank_--, id});
    waiting_.clear();
    ++round_;
    Cost least = cost_;
    std::erase_if(heap_, [&](const Entry& entry) {
      Node& node = nodes_[entry.id];
      const Cost total = priority_.total(space_.state(entry.id), node.g);
      least = std::min(least, total);
      if (total < cost_) return false;
      node.set_open(false);
      --open_count_;
      return true;
    });
    lower_ = std::max(lower_, static_cast<double>(least));
  }

  /// Makes g of each state of the path what the path costs until there.
  template <class Observer>
  void sum_path(Observer&& observer) {
    path_.clear();
    for_each_back_from(goal_, [this](const State& state) { path_.push_back(space_.id(state)); });
    Cost g = nodes_[path_.back()].g;
    for (std::size_t i = path_.size() - 1; i > 0; --i) {
      const State state = space_.state(path_[i - 1]);
      g = static_cast<Cost>(g + step_cost(path_[i], path_[i - 1]));
      Node& node = nodes_[path_[i - 1]];
      if (!(g < node.g)) {
        g = node.g;
        continue;
      }
      const Arrival arrival = node.arrival();
      nodes_.open(node, g, arrival);
      observer.on_relax(state, arrival, g);
      queue(path_[i - 1], node, state);
    }
    cost_ = g;
  }

  Cost step_cost(StateId from, StateId to) const {
    Cost least = std::numeric_limits<Cost>::max();
    space_.for_each_successor(space_.state(from), kNoMove,
                              [&](const State& next, Move /*move*/, Cost cost) {
                                if (space_.id(next) == to) least = std::min(least, cost);
                              });
    return least;
  }

  /// Checks everything that may end the search early. A limit leaves the path that there is.
  template <class Observer>
  bool within_limits(Observer&& observer) {
    outcome_ = limits_.look(metrics_.expanded);
    if (outcome_ == SearchOutcome::running) outcome_ = priority_.stopped().value_or(outcome_);
    if (outcome_ == SearchOutcome::running && priority_.near_overflow(heap_.front().key)) {
      outcome_ = SearchOutcome::cost_overflow;
    }
    if (outcome_ == SearchOutcome::running) return true;
    const bool limited =
        outcome_ == SearchOutcome::expansion_limit || outcome_ == SearchOutcome::time_limit;
    if (limited && has_path_) {
      sum_path(observer);
      gather();
      outcome_ = SearchOutcome::found;
    }
    return false;
  }

  Space space_;
  Priority priority_;
  AnytimeWeights weights_;
  Store<Node> nodes_;
  std::vector<Entry> heap_;       // also older entries of states, which are not live
  std::vector<StateId> waiting_;  // expanded in this round, and reached more cheaply since
  std::vector<StateId> path_;     // from its end to the start
  std::uint32_t age_rank_ = UINT32_MAX;
  std::uint64_t open_count_ = 0;
  std::uint32_t round_ = 1;
  double weight_ = 1;
  bool has_path_ = false;
  Cost cost_{};       // of the path
  double lower_ = 0;  // no path costs less
  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
  State goal_{};
  LimitCheck limits_;
};

}  // namespace wend
