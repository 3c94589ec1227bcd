#pragma once

// Rounds: what a ForwardSearch keeps with DuplicateRule::in_rounds, which makes it ARA*: a best-first search that
// finds a path soon and better ones as long as it may go on.
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
// One search for robots on cells (ara_star) and on lattices (the option initial_weight of lattice and car).
// Planners of poses got an option, not a second name: their motions, costs and heuristics stay in one place, and
// with an initial weight of 1 ARA* is the A* that they are.
//
// The frontier is a HeapFrontier. The priority has these functions too:
//
//   weigh(w)          the weight of the round
//   key(state, g)     g + w h; of equal f, the larger g first. The key has f and g.
//   total(state, g)   g + h, at most the cost of a path through the state
//   stopped()         the outcome of an h that was cut off

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "wend/base/state_id.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// The weights of the rounds: the first one, what is subtracted from the smaller of weight and bound, and the last.
struct AnytimeWeights {
  double first;
  double step;      // above 0
  double last = 1;  // from 1 to `first`
};

/// Adds to a MoveNode or ParentNode whether it is to be expanded, and the last round that expanded it.
template <class Base>
class AnytimeNode : public Base {
 public:
  /// For a state that is reached for the first time.
  void begin() { state_ = 0; }

  /// Is it to be expanded, in this round or later?
  bool is_open() const { return (state_ & kOpen) != 0; }
  void set_open(bool is) { state_ = is ? state_ | kOpen : state_ & ~kOpen; }

  bool expanded_in(std::uint32_t round) const { return state_ >> 1U == round; }
  void expand_in(std::uint32_t round) { state_ = round << 1U; }

 private:
  static constexpr std::uint32_t kOpen = 1;

  std::uint32_t state_;  // bit 0: open; then the round, 0 for none
};

template <class Cost>
class Rounds {
 public:
  explicit Rounds(AnytimeWeights weights) : weights_(weights) {}

  /// The cost of the path is at most this times the least: at least 1, infinite where nothing is proven.
  double bound() const {
    const auto cost = static_cast<double>(cost_);
    if (cost <= lower_) return 1;
    return lower_ > 0 ? cost / lower_ : std::numeric_limits<double>::infinity();
  }

  /// How many states are open or wait, and how many of them this round may expand.
  std::uint64_t open_count() const { return open_count_; }
  std::uint64_t due_count() const { return open_count_ - waiting_.size(); }

  template <class Search>
  void begin(Search& search, const typename Search::State& start) {
    waiting_.clear();
    open_count_ = 0;
    round_ = 1;
    has_path_ = false;
    weigh(search, weights_.first);
    lower_ = static_cast<double>(search.priority_.total(start, Cost{0}));
  }

  /// Will this round not expand it?
  template <class Node>
  bool closed(const Node& node) const {
    return !node.is_open() || node.expanded_in(round_);
  }
  template <class Node>
  void close(Node& node) {
    node.expand_in(round_);
    --open_count_;
  }

  /// Can no path through the state be cheaper than the one that was found?
  template <class Search>
  bool prunes(const Search& search, const typename Search::State& state, Cost g) const {
    return has_path_ && !(search.priority_.total(state, g) < cost_);
  }

  /// A state whose g has fallen is to be expanded, in this round or the next.
  template <class Search>
  void reached(Search& search, const typename Search::State& state, StateId id,
               typename Search::Node& node) {
    if (search.priority_.is_goal(state)) {
      has_path_ = true;
      search.goal_ = state;
      cost_ = node.g;
    }
    open(search, state, id, node);
  }

  /// After an expansion: ends rounds until there is a state to expand, or none that could improve the path.
  template <class Search, class Observer>
  void settle(Search& search, Observer&& observer) {
    auto& frontier = search.frontier_;
    for (;;) {
      while (!frontier.empty() && closed(search.nodes_[frontier.front().id])) frontier.pop();
      if (!frontier.empty() && is_due(search, frontier.front())) return;
      if (!has_path_) {
        search.outcome_ = SearchOutcome::exhausted;
        return;
      }
      end_round(search, observer);
      if (search.outcome_ == SearchOutcome::found) return;
    }
  }

  /// A limit leaves the path that there is.
  template <class Search, class Observer>
  void limit(Search& search, Observer&& observer) {
    const bool limited = search.outcome_ == SearchOutcome::expansion_limit ||
                         search.outcome_ == SearchOutcome::time_limit;
    if (!limited || !has_path_) return;
    sum_path(search, observer);
    leave_out(search);
    begin_round(search);
    search.outcome_ = SearchOutcome::found;
  }

 private:
  void weigh(auto& search, double weight) {
    weight_ = weight;
    search.priority_.weigh(weight);
  }

  void open(auto& search, const auto& state, StateId id, auto& node) {
    const bool was_open = node.is_open();
    if (!was_open) {
      node.set_open(true);
      ++open_count_;
    }
    if (!node.expanded_in(round_)) {
      search.frontier_.push(search.priority_.key(state, node.g), id);
    } else if (!was_open) {
      waiting_.push_back(id);
    }
  }

  /// The goal comes before others of its f, so that the path's end is expanded as in A*.
  bool is_due(const auto& search, const auto& entry) const {
    return !has_path_ || entry.key.f < static_cast<double>(cost_) ||
           entry.id == search.space_.id(search.goal_);
  }

  void end_round(auto& search, auto&& observer) {
    if (!search.priority_.stopped()) {
      lower_ = std::max(lower_, static_cast<double>(cost_) / weight_);
    }
    sum_path(search, observer);
    leave_out(search);
    if (weight_ <= weights_.last || bound() <= weights_.last) {
      search.outcome_ = SearchOutcome::found;
    } else {
      search.outcome_ = SearchOutcome::improved;
      weigh(search, std::max(weights_.last, std::min(weight_, bound()) - weights_.step));
    }
    begin_round(search);
  }

  /// Leaves out the states that are open or wait and cannot improve the path; raises the proven least cost.
  void leave_out(auto& search) {
    Cost least = cost_;
    const auto leaves = [&](StateId id) {
      auto& node = search.nodes_[id];
      const Cost total = search.priority_.total(search.space_.state(id), node.g);
      least = std::min(least, total);
      if (total < cost_) return false;
      node.set_open(false);
      --open_count_;
      return true;
    };
    for (const auto& entry : search.frontier_.entries()) {
      if (is_live(search, entry)) leaves(entry.id);
    }
    std::erase_if(waiting_, leaves);
    lower_ = std::max(lower_, static_cast<double>(least));
  }

  /// Begins the next round with the states that are open or wait.
  void begin_round(auto& search) {
    search.frontier_.rebuild([&](const auto& entry) { return !is_live(search, entry); }, waiting_,
                             [&](StateId id) { return search.key_of(id); });
    waiting_.clear();
    ++round_;
  }

  /// Is it the last entry of a state that this round may expand?
  bool is_live(const auto& search, const auto& entry) const {
    const auto& node = search.nodes_[entry.id];
    return !closed(node) && !(node.g < entry.key.g);
  }

  /// Makes g of each state of the path what the path costs until there.
  void sum_path(auto& search, auto&& observer) {
    path_.clear();
    search.for_each_back_from(search.goal_,
                              [&](const auto& state) { path_.push_back(search.space_.id(state)); });
    Cost g = search.nodes_[path_.back()].g;
    for (std::size_t i = path_.size() - 1; i > 0; --i) {
      const auto state = search.space_.state(path_[i - 1]);
      g = static_cast<Cost>(g + step_cost(search.space_, path_[i], path_[i - 1]));
      auto& node = search.nodes_[path_[i - 1]];
      if (!(g < node.g)) {
        g = node.g;
        continue;
      }
      const auto arrival = node.arrival();
      search.nodes_.open(node, g, arrival);
      observer.on_relax(state, arrival, g);
      open(search, state, path_[i - 1], node);
    }
    cost_ = g;
  }

  static Cost step_cost(const auto& space, StateId from, StateId to) {
    Cost least = std::numeric_limits<Cost>::max();
    space.for_each_successor(space.state(from), kNoMove,
                             [&](const auto& next, Move /*move*/, Cost cost) {
                               if (space.id(next) == to) least = std::min(least, cost);
                             });
    return least;
  }

  AnytimeWeights weights_;
  std::vector<StateId> waiting_;  // expanded in this round, and reached more cheaply since
  std::vector<StateId> path_;     // from its end to the start
  std::uint64_t open_count_ = 0;
  std::uint32_t round_ = 1;
  double weight_ = 1;
  bool has_path_ = false;
  Cost cost_{};       // of the path
  double lower_ = 0;  // no path costs less
};

}  // namespace wend
