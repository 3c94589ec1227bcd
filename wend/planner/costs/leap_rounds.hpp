#pragma once

// LeapRounds: what a LeapSearch keeps as an anytime search, for ara_star: it finds a path soon and better ones as long
// as it may go on. M. Likhachev, G. Gordon and S. Thrun, "ARA*: Anytime A* with Provable Bounds on Sub-Optimality",
// 2003. wend/search/rounds.hpp does the same for a ForwardSearch.
//
// Each round is a weighted A*, f = g + w h, that expands a cell at most once; a cell that is reached more cheaply after
// that waits. A round ends when no open cell has an f below the cost of the path. The next one takes a smaller weight,
// and the cells that waited or are still open. With a weight of 1, cells do not wait, as in astar: then the path is
// optimal.
//
// What is proven: no path costs less than the least g + h of the cells that are open or wait. The bound is the cost over
// it. Buckets are not sorted, so the path of a round with weight w can cost more than w times the least cost: the
// round is repeated, with the cells that waited, until the bound is at most w.
//
// Once there is a first path, and many expansions were of cells that had been expanded before, the last round comes at
// once: other rounds would add to the work until the optimum is proven, and little else.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "wend/base/state_id.hpp"
#include "wend/search/rounds.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// A cell in the queue of a LeapSearch; it has become cheaper since if its node has another g.
template <class Cost>
struct LeapEntry {
  Cost g;
  StateId id;
};

/// `search` is always the LeapSearch that has these rounds and makes them a friend.
template <class Cost>
class LeapRounds {
 public:
  using Entry = LeapEntry<Cost>;

  explicit LeapRounds(AnytimeWeights weights) : weights_(weights) {}

  /// `least` is the estimate at the start.
  void begin(auto& search, std::uint64_t least) {
    waiting_.clear();
    least_ = least;
    round_ = 0;
    repeated_ = 0;
    goal_is_due_ = false;
    weigh(search, weights_.first);
  }

  /// A path of this cost costs at most this times the least: at least 1, infinite where nothing is proven.
  double bound(std::uint64_t cost) const {
    if (cost <= least_) return 1;
    return least_ > 0 ? static_cast<double>(cost) / static_cast<double>(least_)
                      : std::numeric_limits<double>::infinity();
  }

  /// f = g + w h.
  std::uint64_t key(std::uint64_t g, std::uint64_t h) const {
    return g + h + whole((weight_ - 1) * static_cast<double>(static_cast<std::int64_t>(h)));
  }

  /// A cell whose g has fallen is to be expanded, in this round or later.
  void open(auto& queue, const auto& node, const Entry& entry, std::uint64_t h) {
    if (weight_ > 1 && node.expanded_in(round_)) {
      waiting_.push_back(entry);
    } else {
      queue.push(key(entry.g, h), entry);
    }
  }

  void close(auto& node) {
    if (!node.expanded_in(kNoRound)) ++repeated_;
    node.expand_in(round_);
  }

  /// The goal of the path is to be expanded, at the end of the round.
  bool goal_is_due() const { return goal_is_due_; }
  void set_goal_due(bool is) { goal_is_due_ = is; }

  /// Has the last round to come before this one is over? The first path, with its bound, is waited for.
  bool hurries(std::uint64_t expanded) const {
    return weight_ > weights_.last && weight_ < weights_.first && repeats(expanded);
  }

  /// Ends rounds until there is something to expand, or nothing that could improve the path.
  void end_round(auto& search) {
    do {
      prove(search);
      if (waiting_.empty()) {
        return search.end(search.has_path() ? SearchOutcome::found : SearchOutcome::exhausted);
      }
      const double weight = next_weight(search);
      if (weight < weight_) search.end(SearchOutcome::improved);
      weigh(search, weight);
      for (const Entry& entry : waiting_) search.push(entry);
      waiting_.clear();
    } while (!search.any_due());
  }

  /// A limit leaves the path that there is.
  void limit(auto& search) {
    const bool limited = search.outcome() == SearchOutcome::expansion_limit ||
                         search.outcome() == SearchOutcome::time_limit;
    if (!limited || !search.has_path()) return;
    prove(search);
    search.end(SearchOutcome::found);
  }

 private:
  static constexpr std::uint32_t kNoRound = 0;
  static constexpr std::uint64_t kMostRepeated = 4;  // a repeated expansion for so many others
  static constexpr double kMostWhole = 0x1p62;
  static constexpr double kRounding = 1 + 1e-9;  // of weights and bounds

  static std::uint64_t whole(double value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::min(value, kMostWhole)));
  }

  /// Was much of the work done before?
  bool repeats(std::uint64_t expanded) const {
    return kMostRepeated * repeated_ > expanded - repeated_;
  }

  /// Begins a round with an empty queue.
  void weigh(auto& search, double weight) {
    constexpr unsigned kBuckets = 1024;  // that the weighted estimate at the start is wide
    weight_ = weight;
    ++round_;
    unsigned width_bits = search.width_bits();
    if (weight > 1) {
      const std::uint64_t far = whole(weight * static_cast<double>(least_)) / kBuckets;
      width_bits = std::max(width_bits, static_cast<unsigned>(std::bit_width(far)));
    }
    search.queue_.begin(least_, width_bits);
  }

  double next_weight(const auto& search) const {
    if (!search.has_path()) return weight_;
    const std::uint64_t expanded = search.metrics().expanded;
    const double proven = bound(search.best_);
    if (proven > weight_ * kRounding) return hurries(expanded) ? weights_.last : weight_;
    if (repeats(expanded)) return weights_.last;
    return std::max(weights_.last, std::min(weight_, proven) - weights_.step);
  }

  /// Lets all cells wait that are open and can improve the path; raises the proven least cost.
  void prove(auto& search) {
    if (search.has_path()) sum_path(search);
    while (!search.queue_.empty()) waiting_.push_back(search.queue_.pop());
    std::uint64_t least = search.best_;
    std::erase_if(waiting_, [&](const Entry& entry) {
      if (search.is_stale(entry)) return true;
      const std::uint64_t total = search.total(entry);
      if (total >= search.best_) return true;
      least = std::min(least, total);
      return false;
    });
    if (search.has_path()) least_ = std::max(least_, least);
  }

  /// Makes g of each cell of the path what the path costs until there: some may have become cheaper since their
  /// successors were reached.
  void sum_path(auto& search) {
    path_.clear();
    for (StateId id = search.goal_id();; id = search.parent(id)) {
      path_.push_back(id);
      if (!search.has_parent(id)) break;
    }
    std::uint64_t g = 0;
    for (std::size_t i = path_.size() - 1; i-- > 0;) g = search.reach_from_parent(path_[i]);
    search.best_ = g;
  }

  AnytimeWeights weights_;
  double weight_ = 1;
  std::uint32_t round_ = kNoRound;
  std::uint64_t least_ = 0;     // no path costs less
  std::uint64_t repeated_ = 0;  // expansions of cells that had been expanded before
  bool goal_is_due_ = false;
  std::vector<Entry> waiting_;  // expanded in this round, and reached more cheaply since
  std::vector<StateId> path_;   // from its end to the start
};

}  // namespace wend
