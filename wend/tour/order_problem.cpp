#include "wend/tour/order_problem.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace wend {
namespace {

constexpr double kLargestCost = 1e150;  // sums stay finite

std::optional<Error> no_such_stop(int stop, int stops, const std::string& option) {
  if (stop >= 0 && stop < stops) return std::nullopt;
  return Error{Status::invalid_option,
               option + ": there is no stop " + std::to_string(stop) + "; stops are 0 to " +
                   std::to_string(stops - 1),
               option};
}

std::optional<Error> fault_of(const CostMatrix& costs) {
  if (costs.size() == 0)
    return Error{Status::invalid_option, "there are no stops to order", "stops"};
  for (int from = 0; from < costs.size(); ++from) {
    for (int to = 0; to < costs.size(); ++to) {
      const double cost = costs(from, to);
      if (from == to || cost == CostMatrix::kNoWay) continue;
      if (cost >= 0 && cost <= kLargestCost) continue;
      return Error{Status::invalid_option,
                   "the cost from stop " + std::to_string(from) + " to stop " + std::to_string(to) +
                       (cost > kLargestCost ? " is larger than 1e150" : " is negative or NaN"),
                   "costs"};
    }
  }
  return std::nullopt;
}

std::optional<Error> fault_of_ends(const TourOptions& options, int stops) {
  if (options.start) {
    if (auto fault = no_such_stop(*options.start, stops, "start")) return fault;
  }
  if (!options.end) return std::nullopt;
  if (auto fault = no_such_stop(*options.end, stops, "end")) return fault;
  if (options.closed) {
    return Error{Status::invalid_option, "end: a closed tour ends where it starts", "end"};
  }
  if (options.start == options.end && stops > 1) {
    return Error{Status::invalid_option,
                 "end: an open tour cannot end with the stop it starts with; ask for a closed one",
                 "end"};
  }
  return std::nullopt;
}

std::optional<Error> fault_of_pairs(const std::vector<StopPair>& pairs, int stops,
                                    const std::string& option) {
  for (const StopPair& pair : pairs) {
    for (const int stop : {pair.first, pair.second}) {
      if (auto fault = no_such_stop(stop, stops, option)) return fault;
    }
    if (pair.first != pair.second) continue;
    return Error{Status::invalid_option,
                 option + ": stop " + std::to_string(pair.first) + " is paired with itself",
                 option};
  }
  return std::nullopt;
}

std::optional<Error> fault_of_options(const TourOptions& options, int stops) {
  if (auto fault = fault_of_ends(options, stops)) return fault;
  if (auto fault = fault_of_pairs(options.before, stops, "before")) return fault;
  return fault_of_pairs(options.fixed, stops, "fixed");
}

/// The costs between the stops, and of the extra place of an open tour.
CostMatrix with_extra_place(const CostMatrix& costs, const OrderProblem& problem) {
  const int stops = costs.size();
  CostMatrix extended(stops + 1, 0);
  for (int stop = 0; stop < stops; ++stop) {
    for (int to = 0; to < stops; ++to) extended.set(stop, to, costs(stop, to));
    if (stops == 1) continue;
    const bool begins =
        problem.start == OrderProblem::kNone ? stop != problem.end : stop == problem.start;
    const bool ends =
        problem.end == OrderProblem::kNone ? stop != problem.start : stop == problem.end;
    if (!begins) extended.set(stops, stop, CostMatrix::kNoWay);
    if (!ends) extended.set(stop, stops, CostMatrix::kNoWay);
  }
  return extended;
}

/// Ties two places; false if one of them is tied to two others.
bool tie(OrderProblem& problem, int a, int b) {
  if (problem.tied(a, b)) return true;
  for (const auto& [place, other] : {std::array{a, b}, std::array{b, a}}) {
    auto& of = problem.ties[static_cast<std::size_t>(place)];
    if (of[1] != OrderProblem::kNone) return false;
    (of[0] == OrderProblem::kNone ? of[0] : of[1]) = other;
  }
  return true;
}

/// Marks the places that ties join to `place`; returns how many were not marked before.
int mark_chain(const OrderProblem& problem, int place, std::vector<char>& seen) {
  std::vector<int> open{place};
  int marked = 0;
  while (!open.empty()) {
    const auto at = static_cast<std::size_t>(open.back());
    open.pop_back();
    if (seen[at] != 0) continue;
    seen[at] = 1;
    ++marked;
    for (const int other : problem.ties[at]) {
      if (other != OrderProblem::kNone) open.push_back(other);
    }
  }
  return marked;
}

/// Do ties form a ring that leaves some place out?
bool have_short_ring(const OrderProblem& problem) {
  std::vector<char> seen(problem.ties.size(), 0);
  for (int place = 0; place < problem.places(); ++place) {
    const bool inner = problem.ties[static_cast<std::size_t>(place)][1] != OrderProblem::kNone;
    if (!inner) mark_chain(problem, place, seen);
  }
  for (int place = 0; place < problem.places(); ++place) {
    if (seen[static_cast<std::size_t>(place)] != 0) continue;
    if (mark_chain(problem, place, seen) < problem.places()) return true;
  }
  return false;
}

Expected<void, Error> tie_all(OrderProblem& problem, const TourOptions& options) {
  const auto crowded = [](int stop) {
    return failure(
        Status::invalid_option,
        "fixed: stop " + std::to_string(stop) + " cannot follow more than two others directly",
        "fixed");
  };
  for (const int end : {problem.start, problem.end}) {
    if (end != OrderProblem::kNone) tie(problem, problem.first, end);
  }
  for (const StopPair& pair : options.fixed) {
    if (!tie(problem, pair.first, pair.second)) return crowded(pair.first);
  }
  if (have_short_ring(problem)) {
    return failure(Status::invalid_option, "fixed: the pairs form a ring that leaves stops out",
                   "fixed");
  }
  return {};
}

}  // namespace

Expected<OrderProblem, Error> make_order_problem(const CostMatrix& costs,
                                                 const TourOptions& options) {
  if (auto fault = fault_of(costs)) return Unexpected<Error>(std::move(*fault));
  const int stops = costs.size();
  if (auto fault = fault_of_options(options, stops)) return Unexpected<Error>(std::move(*fault));
  OrderProblem problem;
  problem.stops = stops;
  problem.closed = options.closed;
  problem.before = options.before;
  problem.symmetric = costs.symmetric();
  problem.first = options.closed ? options.start.value_or(0) : stops;
  if (!options.closed) {
    problem.start = options.start.value_or(OrderProblem::kNone);
    problem.end = options.end.value_or(OrderProblem::kNone);
  }
  problem.costs = options.closed ? costs : with_extra_place(costs, problem);
  problem.ties.assign(static_cast<std::size_t>(problem.places()),
                      {OrderProblem::kNone, OrderProblem::kNone});
  if (auto tied = tie_all(problem, options); !tied) return Unexpected<Error>(tied.error());
  return problem;
}

double cost_of_order(const CostMatrix& costs, bool closed, const std::vector<int>& order) {
  double sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i) sum += costs(order[i - 1], order[i]);
  return closed && !order.empty() ? sum + costs(order.back(), order.front()) : sum;
}

bool obeys(const OrderProblem& problem, const std::vector<int>& order) {
  const auto count = order.size();
  if (count != static_cast<std::size_t>(problem.stops)) return false;
  std::vector<std::size_t> rank(count, count);
  for (std::size_t i = 0; i < count; ++i) rank[static_cast<std::size_t>(order[i])] = i;
  if (std::ranges::find(rank, count) != rank.end()) return false;
  if (problem.closed && order.front() != problem.first) return false;
  if (problem.start != OrderProblem::kNone && order.front() != problem.start) return false;
  if (problem.end != OrderProblem::kNone && order.back() != problem.end) return false;
  const auto rank_of = [&](int stop) { return rank[static_cast<std::size_t>(stop)]; };
  const auto late = [&](const StopPair& pair) {
    return rank_of(pair.first) > rank_of(pair.second);
  };
  if (std::ranges::any_of(problem.before, late)) return false;
  for (int stop = 0; stop < problem.stops; ++stop) {
    for (const int other : problem.ties[static_cast<std::size_t>(stop)]) {
      if (other < stop) continue;  // also kNone
      if (other >= problem.stops) continue;
      const std::size_t apart = rank_of(other) > rank_of(stop) ? rank_of(other) - rank_of(stop)
                                                               : rank_of(stop) - rank_of(other);
      if (apart != 1 && !(problem.closed && apart + 1 == count)) return false;
    }
  }
  return true;
}

}  // namespace wend
