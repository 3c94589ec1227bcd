#pragma once

// The costs of an OrderProblem as whole numbers between nodes, for OrderSearch: sums are exact and equal everywhere.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/tour/order_problem.hpp"

namespace wend {

using WholeCost = std::int32_t;

/// The largest cost that a way can have; the least is 0.
inline constexpr WholeCost kLargestWholeCost = WholeCost{1} << 22;
/// Where there is no way. Search avoids it at almost any price.
inline constexpr WholeCost kNoWholeCost = WholeCost{1} << 28;
/// Is added between places that are tied.
inline constexpr WholeCost kTiedWholeCost = -(WholeCost{1} << 29);
/// Between the two nodes of a place.
inline constexpr WholeCost kInsidePlace = -(WholeCost{1} << 30);

/// Costs between places, row after row; those of ties are lower by kTiedWholeCost. `both_ways`: the cheaper of the two ways.
std::vector<WholeCost> whole_costs(const OrderProblem& problem, bool both_ways);

/// A node is a place.
class CostsBothWays {
 public:
  static constexpr int kNodesOfPlace = 1;
  /// Must nodes with this cost stay neighbours?
  static bool inseparable(WholeCost cost) { return cost < 0; }

  explicit CostsBothWays(const OrderProblem& problem)
      : places_(static_cast<std::size_t>(problem.places())), costs_(whole_costs(problem, true)) {}

  WholeCost operator()(int a, int b) const {
    return costs_[static_cast<std::size_t>(a) * places_ + static_cast<std::size_t>(b)];
  }

 private:
  std::size_t places_;
  std::vector<WholeCost> costs_;
};

/// Node 2p is where place p is entered, 2p + 1 where it is left.
class CostsOneWay {
 public:
  static constexpr int kNodesOfPlace = 2;
  /// Must nodes with this cost stay neighbours? (Those of a tie may change their direction.)
  static bool inseparable(WholeCost cost) { return cost == kInsidePlace; }

  explicit CostsOneWay(const OrderProblem& problem)
      : places_(static_cast<std::size_t>(problem.places())), costs_(whole_costs(problem, false)) {}

  WholeCost operator()(int a, int b) const {
    if (((a ^ b) & 1) == 0) return kNoWholeCost;
    const int from = (a & 1) != 0 ? a : b;
    const int to = (a & 1) != 0 ? b : a;
    if (from == to + 1) return kInsidePlace;
    return costs_[static_cast<std::size_t>(from / 2) * places_ + static_cast<std::size_t>(to / 2)];
  }

 private:
  std::size_t places_;
  std::vector<WholeCost> costs_;
};

}  // namespace wend
