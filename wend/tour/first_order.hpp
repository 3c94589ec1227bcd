#pragma once

// The first order of a tour: from each stop to the nearest that may follow. Stops that are tied follow each other.

#include <optional>
#include <vector>

#include "wend/tour/order_problem.hpp"

namespace wend {

/// An order that obeys the problem, maybe over ways that do not exist; nothing if options contradict each other.
/// O(stops^2 + pairs).
std::optional<std::vector<int>> first_order(const OrderProblem& problem);

}  // namespace wend
