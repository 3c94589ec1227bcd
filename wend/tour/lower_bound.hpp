#pragma once

// What no order can cost less than: the bound of Held and Karp (1970) by 1-trees. A tour is a spanning tree with
// one more edge; the cheapest of those costs no more. A weight at each place, paid twice by every tour, makes
// trees whose places have two edges cheaper than others; weights are moved until that hardly helps.
//
// Costs are rounded down to whole multiples of a power of two, so all sums are exact. Of ways with a direction the
// cheaper one counts, after what all ways to a place cost more than those from there has been shared between both.

#include "wend/base/deadline.hpp"
#include "wend/tour/order_problem.hpp"

namespace wend {

/// The bound of a problem with at least 3 places. `cost`: of a tour that exists. Less precise if the deadline passes.
/// O(places^2) for the first and the last tree, O(places log places) for those between.
double lower_bound(const OrderProblem& problem, double cost, const Deadline& deadline);

}  // namespace wend
