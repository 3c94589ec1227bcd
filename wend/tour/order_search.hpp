#pragma once

// OrderSearch: a closed tour over nodes whose costs are whole numbers and the same both ways, and how it gets shorter.
//
// A change removes up to three edges and adds as many, one after the other, as long as what is saved so far exceeds what
// is paid (Lin and Kernighan, 1973); whether the result is one tour is asked only if it would be shorter. A kick reverses the
// order of three pieces nearby (a double bridge); if the changes around it do not win its cost back, all is undone.
//
// Costs with a direction are of pairs of nodes: one where a place is entered, one where it is left, tied together. A change
// then never reverses anything (Jonker and Volgenant, 1983).

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "wend/tour/order_problem.hpp"

namespace wend {

class OrderSearch {
 public:
  virtual ~OrderSearch() = default;

  /// Looks for changes everywhere, until none pays.
  virtual void settle() = 0;
  /// One kick; is the tour shorter than before?
  virtual bool kick() = 0;
  /// The present order of the stops.
  virtual std::vector<int> order() const = 0;
};

/// A search from an order that obeys the problem. Every later order does too. At least 8 places.
std::unique_ptr<OrderSearch> make_order_search(const OrderProblem& problem,
                                               const std::vector<int>& order, std::uint64_t seed);

}  // namespace wend
