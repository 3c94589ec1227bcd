#include "wend/tour/exact_order.hpp"

#include <algorithm>
#include <cstdint>

namespace wend {
namespace {

using StopSet = std::uint32_t;

StopSet bit(int stop) { return StopSet{1} << static_cast<unsigned>(stop); }

class ExactOrder {
 public:
  explicit ExactOrder(const OrderProblem& problem)
      : problem_(problem), stops_(problem.stops), all_(bit(problem.stops) - 1) {
    const std::size_t states = (std::size_t{all_} + 1) * static_cast<std::size_t>(stops_);
    least_.assign(states, CostMatrix::kNoWay);
    arrived_from_.assign(states, static_cast<std::int8_t>(OrderProblem::kNone));
    earlier_.assign(static_cast<std::size_t>(stops_), 0);
    tied_.assign(static_cast<std::size_t>(stops_), 0);
    for (const StopPair& pair : problem.before) {
      earlier_[static_cast<std::size_t>(pair.second)] |= bit(pair.first);
    }
    for (int stop = 0; stop < stops_; ++stop) {
      for (const int other : problem.ties[static_cast<std::size_t>(stop)]) {
        if (other >= 0 && other < stops_) tied_[static_cast<std::size_t>(stop)] |= bit(other);
      }
    }
  }

  std::optional<std::vector<int>> find() {
    for (int stop = 0; stop < stops_; ++stop) {
      if (may_begin(stop)) least_[state(bit(stop), stop)] = 0;
    }
    for (StopSet seen = 1; seen <= all_; ++seen) {
      for (int last = 0; last < stops_; ++last) {
        if (least_[state(seen, last)] < CostMatrix::kNoWay) extend(seen, last);
      }
    }
    return traced_back();
  }

 private:
  std::size_t state(StopSet seen, int last) const {
    return std::size_t{seen} * static_cast<std::size_t>(stops_) + static_cast<std::size_t>(last);
  }
  StopSet earlier(int stop) const { return earlier_[static_cast<std::size_t>(stop)]; }
  StopSet tied(int stop) const { return tied_[static_cast<std::size_t>(stop)]; }

  bool may_begin(int stop) const {
    if (problem_.closed) return stop == problem_.first && earlier(stop) == 0;
    if (stop == problem_.end && stops_ > 1) return false;
    return (problem_.start == OrderProblem::kNone || stop == problem_.start) && earlier(stop) == 0;
  }

  void extend(StopSet seen, int last) {
    for (int next = 0; next < stops_; ++next) {
      if ((seen & bit(next)) != 0 || !may_follow(seen, last, next)) continue;
      const std::size_t reached = state(seen | bit(next), next);
      const double cost = least_[state(seen, last)] + problem_.costs(last, next);
      if (cost >= least_[reached]) continue;
      least_[reached] = cost;
      arrived_from_[reached] = static_cast<std::int8_t>(last);
    }
  }

  bool may_follow(StopSet seen, int last, int next) const {
    const StopSet reached = seen | bit(next);
    if ((earlier(next) & ~seen) != 0) return false;
    if (next == problem_.end && reached != all_) return false;
    const bool leaves_the_ring = problem_.closed && last == problem_.first;
    if (!leaves_the_ring && (tied(last) & ~reached) != 0) return false;
    // Who is tied to the first stop of a closed tour may also come last.
    const bool returns =
        problem_.closed && last != problem_.first && problem_.tied(next, problem_.first);
    return !returns || reached == all_;
  }

  std::optional<std::vector<int>> traced_back() const {
    int best = OrderProblem::kNone;
    double least = CostMatrix::kNoWay;
    for (int last = 0; last < stops_; ++last) {
      const double back = problem_.closed ? problem_.costs(last, problem_.first) : 0;
      const double cost = least_[state(all_, last)] + back;
      if (cost >= least) continue;
      least = cost;
      best = last;
    }
    if (best == OrderProblem::kNone) return std::nullopt;
    std::vector<int> order;
    StopSet seen = all_;
    for (int at = best; at != OrderProblem::kNone;) {
      order.push_back(at);
      const int from = arrived_from_[state(seen, at)];
      seen &= ~bit(at);
      at = from;
    }
    std::ranges::reverse(order);
    return order;
  }

  const OrderProblem& problem_;
  int stops_;
  StopSet all_;
  std::vector<double> least_;
  std::vector<std::int8_t> arrived_from_;
  std::vector<StopSet> earlier_;
  std::vector<StopSet> tied_;
};

}  // namespace

std::optional<std::vector<int>> best_order(const OrderProblem& problem) {
  return ExactOrder(problem).find();
}

}  // namespace wend
