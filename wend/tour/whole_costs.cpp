#include "wend/tour/whole_costs.hpp"

#include <algorithm>
#include <cmath>

namespace wend {

namespace {

double largest_of(const OrderProblem& problem) {
  double largest = 0;
  for (const double cost : problem.costs.values()) {
    if (cost < CostMatrix::kNoWay) largest = std::max(largest, cost);
  }
  return largest;
}

}  // namespace

std::vector<WholeCost> whole_costs(const OrderProblem& problem, bool both_ways) {
  const double largest = largest_of(problem);
  const int places = problem.places();
  const auto whole_of = [&](int from, int to) {
    const double way = problem.costs(from, to);
    const double cost = both_ways ? std::min(way, problem.costs(to, from)) : way;
    if (cost == CostMatrix::kNoWay) return kNoWholeCost;
    const WholeCost whole =
        largest > 0 ? static_cast<WholeCost>(std::lround(cost / largest * kLargestWholeCost)) : 0;
    return problem.tied(from, to) ? kTiedWholeCost + whole : whole;
  };
  std::vector<WholeCost> whole;
  whole.reserve(problem.costs.values().size());
  for (int from = 0; from < places; ++from) {
    for (int to = 0; to < places; ++to) whole.push_back(whole_of(from, to));
  }
  return whole;
}

}  // namespace wend
