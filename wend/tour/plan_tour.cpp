#include "wend/tour/plan_tour.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "wend/base/deadline.hpp"
#include "wend/tour/exact_order.hpp"
#include "wend/tour/first_order.hpp"
#include "wend/tour/lower_bound.hpp"
#include "wend/tour/order_problem.hpp"
#include "wend/tour/order_search.hpp"

namespace wend {
namespace {

constexpr std::uint64_t kKicksOfStop = 20;
constexpr std::uint64_t kKicksBetweenClockReads = 16;

Unexpected<Error> contradicting() {
  return failure(Status::invalid_option,
                 "no order obeys all of start, end, before and fixed: they contradict each other");
}

Unexpected<Error> without_way() {
  return failure(Status::unreachable, "no order was found whose legs all exist");
}

class TourSearch {
 public:
  TourSearch(const CostMatrix& costs, const TourOptions& options, const OrderProblem& problem)
      : costs_(costs), options_(options), problem_(problem), deadline_(options.limits) {}

  Expected<Tour, Error> run() {
    const auto begin = first_order(problem_);
    if (!begin) return contradicting();
    if (problem_.stops <= kStopsOfExactOrders) return exact();
    take(*begin);
    if (deadline_.passed()) return ended_early();
    const auto search = make_order_search(problem_, *begin, options_.seed);
    search->settle();
    take(search->order());
    bound();
    kick(*search);
    if (!(tour_.cost < CostMatrix::kNoWay)) return without_way();
    return std::move(tour_);
  }

 private:
  Expected<Tour, Error> exact() {
    const auto order = best_order(problem_);
    if (!order) return without_way();
    take(*order);
    tour_.bound = tour_.cost;
    return std::move(tour_);
  }

  Expected<Tour, Error> ended_early() {
    tour_.status = deadline_.status();
    if (!(tour_.cost < CostMatrix::kNoWay)) {
      return failure(deadline_.status(), "the search for an order was " + deadline_.text());
    }
    return std::move(tour_);
  }

  void bound() {
    if (options_.bound && tour_.cost < CostMatrix::kNoWay) {
      tour_.bound = lower_bound(problem_, tour_.cost, deadline_);
    }
  }

  void kick(OrderSearch& search) {
    const bool timed = options_.limits.seconds < std::numeric_limits<double>::infinity();
    const std::uint64_t most =
        options_.kicks.value_or(timed ? std::numeric_limits<std::uint64_t>::max()
                                      : kKicksOfStop * static_cast<std::uint64_t>(problem_.stops));
    bool improved = false;
    for (; tour_.kicks < most; ++tour_.kicks) {
      if (tour_.kicks % kKicksBetweenClockReads == 0 && deadline_.passed()) {
        tour_.status = deadline_.status();
        break;
      }
      if (!search.kick()) continue;
      improved = true;
      if (options_.improved) take(search.order());
    }
    if (improved) take(search.order());
  }

  void take(std::vector<int> order) {
    const double cost = cost_of_order(costs_, options_.closed, order);
    if (!tour_.order.empty() && cost >= tour_.cost) return;
    tour_.cost = cost;
    tour_.order = std::move(order);
    if (options_.improved) options_.improved(cost, tour_.order);
  }

  const CostMatrix& costs_;
  const TourOptions& options_;
  const OrderProblem& problem_;
  Deadline deadline_;
  Tour tour_;
};

}  // namespace

Expected<Tour, Error> plan_tour(const CostMatrix& costs, const TourOptions& options) {
  const auto problem = make_order_problem(costs, options);
  if (!problem) return Unexpected<Error>(problem.error());
  return TourSearch(costs, options, *problem).run();
}

}  // namespace wend
