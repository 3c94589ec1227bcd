#include "wend/tour/first_order.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace wend {
namespace {

/// Stops that must follow each other, in this order or in the reverse one.
struct Chain {
  std::vector<int> stops;
  bool forward = true;  // may it be passed so?
  bool backward = true;
  int waits = 0;  // pairs whose first stop, of another chain, has not been visited
};

/// Who stands beside the first stop of a closed tour; kNone: anyone.
struct RingEnds {
  int second = OrderProblem::kNone;
  int last = OrderProblem::kNone;
};

class FirstOrder {
 public:
  FirstOrder(const OrderProblem& problem, const RingEnds& ends)
      : problem_(problem),
        chain_of_(static_cast<std::size_t>(problem.stops), OrderProblem::kNone),
        followers_(static_cast<std::size_t>(problem.stops)) {
    make_chains();
    pin_ends(ends);
    for (const StopPair& pair : problem.before) note(pair);
  }

  std::optional<std::vector<int>> find() {
    std::vector<int> order;
    for (std::size_t passed = 0; passed < chains_.size(); ++passed) {
      const Entry entry = nearest(order.empty() ? OrderProblem::kNone : order.back(), passed);
      if (entry.chain == OrderProblem::kNone) return std::nullopt;
      pass(entry, order);
    }
    if (!obeys(problem_, order)) return std::nullopt;
    return order;
  }

 private:
  /// Where the order goes on: a chain, and from which end.
  struct Entry {
    int chain = OrderProblem::kNone;
    bool forward = true;
  };

  int number_of(int stop) const { return chain_of_[static_cast<std::size_t>(stop)]; }
  Chain& chain_of(int stop) { return chains_[static_cast<std::size_t>(number_of(stop))]; }

  /// The place beside another; the first stop of a closed tour cuts the ring.
  bool joins(int stop, int other) const {
    if (other < 0 || other >= problem_.stops) return false;
    return !problem_.closed || (stop != problem_.first && other != problem_.first);
  }

  int joined(int stop) const {
    const auto& of = problem_.ties[static_cast<std::size_t>(stop)];
    return static_cast<int>(joins(stop, of[0])) + static_cast<int>(joins(stop, of[1]));
  }

  void make_chains() {
    for (int stop = 0; stop < problem_.stops; ++stop) {
      if (joined(stop) < 2 && chain_of_[static_cast<std::size_t>(stop)] == OrderProblem::kNone) {
        add_chain(stop);
      }
    }
  }

  void add_chain(int begin) {
    Chain chain;
    for (int at = begin; at != OrderProblem::kNone;) {
      chain.stops.push_back(at);
      chain_of_[static_cast<std::size_t>(at)] = static_cast<int>(chains_.size());
      int next = OrderProblem::kNone;
      for (const int other : problem_.ties[static_cast<std::size_t>(at)]) {
        if (joins(at, other) && chain_of_[static_cast<std::size_t>(other)] == OrderProblem::kNone) {
          next = other;
        }
      }
      at = next;
    }
    chains_.push_back(std::move(chain));
  }

  /// Ends of the order are ends of their chains.
  void pin_ends(const RingEnds& ends) {
    if (problem_.closed) opening_.push_back(number_of(problem_.first));
    const int begin = problem_.closed ? ends.second : problem_.start;
    const int end = problem_.closed ? ends.last : problem_.end;
    if (begin != OrderProblem::kNone) {
      pin(begin, true);
      opening_.push_back(number_of(begin));
    }
    if (end == OrderProblem::kNone) return;
    pin(end, false);
    last_chain_ = number_of(end);
  }

  void pin(int stop, bool begins) {
    Chain& chain = chain_of(stop);
    if (chain.stops.size() == 1) return;
    ((chain.stops.front() == stop) == begins ? chain.backward : chain.forward) = false;
  }

  void note(const StopPair& pair) {
    Chain& later = chain_of(pair.second);
    if (&later != &chain_of(pair.first)) {
      ++later.waits;
      followers_[static_cast<std::size_t>(pair.first)].push_back(pair.second);
      return;
    }
    const auto first = std::ranges::find(later.stops, pair.first);
    const bool as_listed = first < std::ranges::find(later.stops, pair.second);
    (as_listed ? later.backward : later.forward) = false;
  }

  bool is_next(int number, std::size_t passed) const {
    const Chain& chain = chains_[static_cast<std::size_t>(number)];
    if (chain.stops.empty() || chain.waits > 0) return false;
    if (passed < opening_.size()) return number == opening_[passed];
    return number != last_chain_ || passed + 1 == chains_.size();
  }

  Entry nearest(int at, std::size_t passed) const {
    Entry best;
    double least = 0;
    for (int number = 0; number < static_cast<int>(chains_.size()); ++number) {
      if (!is_next(number, passed)) continue;
      const Chain& chain = chains_[static_cast<std::size_t>(number)];
      for (const bool forward : {true, false}) {
        if (!(forward ? chain.forward : chain.backward)) continue;
        const int stop = forward ? chain.stops.front() : chain.stops.back();
        const double cost = at == OrderProblem::kNone ? 0 : problem_.costs(at, stop);
        if (best.chain != OrderProblem::kNone && cost >= least) continue;
        best = {number, forward};
        least = cost;
      }
    }
    return best;
  }

  void pass(Entry entry, std::vector<int>& order) {
    Chain& chain = chains_[static_cast<std::size_t>(entry.chain)];
    if (!entry.forward) std::ranges::reverse(chain.stops);
    for (const int stop : chain.stops) {
      order.push_back(stop);
      for (const int follower : followers_[static_cast<std::size_t>(stop)]) {
        --chain_of(follower).waits;
      }
    }
    chain.stops.clear();
  }

  const OrderProblem& problem_;
  std::vector<Chain> chains_;
  std::vector<int> chain_of_;
  std::vector<std::vector<int>> followers_;
  std::vector<int> opening_;  // the chains that must come first
  int last_chain_ = OrderProblem::kNone;
};

}  // namespace

std::optional<std::vector<int>> first_order(const OrderProblem& problem) {
  if (!problem.closed) return FirstOrder(problem, {}).find();
  const auto& beside = problem.ties[static_cast<std::size_t>(problem.first)];
  auto order = FirstOrder(problem, {beside[0], beside[1]}).find();
  if (order || beside[0] == OrderProblem::kNone) return order;
  return FirstOrder(problem, {beside[1], beside[0]}).find();
}

}  // namespace wend
