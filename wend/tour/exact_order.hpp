#pragma once

// The best order of a few stops, by dynamic programming over sets of stops (Bellman, Held and Karp, 1962).

#include <optional>
#include <vector>

#include "wend/tour/order_problem.hpp"

namespace wend {

/// The most stops for which best_order() is asked.
inline constexpr int kStopsOfExactOrders = 12;

/// The cheapest order that obeys the problem; nothing if no order with a finite cost does.
/// O(2^stops stops^2) time.
std::optional<std::vector<int>> best_order(const OrderProblem& problem);

}  // namespace wend
