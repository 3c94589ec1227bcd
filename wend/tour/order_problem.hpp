#pragma once

// OrderProblem: any tour as a closed one over "places", the stops and, for an open tour, one more place where it
// ends and begins: ways to and from there are free. A tour that must begin or end with a stop has the stop tied
// to that place.

#include <array>
#include <cstdint>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/tour/cost_matrix.hpp"
#include "wend/tour/plan_tour.hpp"

namespace wend {

struct OrderProblem {
  static constexpr int kNone = -1;

  CostMatrix costs;                      // between places
  std::vector<std::array<int, 2>> ties;  // of each place: whom it must stand beside; kNone
  std::vector<StopPair> before;
  int stops = 0;      // places 0 to stops - 1
  int first = 0;      // the place that an order begins with: the extra place, or the start
  int start = kNone;  // of an open tour
  int end = kNone;
  bool closed = false;
  bool symmetric = false;

  int places() const { return costs.size(); }
  bool tied(int a, int b) const {
    const auto& of = ties[static_cast<std::size_t>(a)];
    return of[0] == b || of[1] == b;
  }
};

/// Checks matrix and options, as plan_tour() says. O(stops^2).
Expected<OrderProblem, Error> make_order_problem(const CostMatrix& costs,
                                                 const TourOptions& options);

/// The cost of an order of stops, all legs summed in order.
double cost_of_order(const CostMatrix& costs, bool closed, const std::vector<int>& order);

/// Does an order of stops obey the problem?
bool obeys(const OrderProblem& problem, const std::vector<int>& order);

}  // namespace wend
