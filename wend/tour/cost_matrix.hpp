#pragma once

// CostMatrix: what every way between two of n stops costs. A row is a stop that one leaves, a column a stop that one
// reaches. Costs are the same both ways or not.
//
//   wend::CostMatrix costs(3, 1.0);        // 1 from every stop to every other
//   costs.set(0, 2, wend::CostMatrix::kNoWay);
//   const double there = costs(0, 1);

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"

namespace wend {

class WEND_API CostMatrix {
 public:
  /// The cost from a stop to one that cannot be reached from there.
  static constexpr double kNoWay = std::numeric_limits<double>::infinity();

  /// No stops.
  CostMatrix() = default;
  /// 0 from each stop to itself, `cost` between any two others. `stops` is not negative.
  explicit CostMatrix(int stops, double cost = kNoWay);

  /// The number of stops.
  int size() const { return size_; }
  /// The cost from one stop to another.
  double operator()(int from, int to) const { return costs_[index(from, to)]; }
  /// Sets the cost from one stop to another.
  void set(int from, int to, double cost) { costs_[index(from, to)] = cost; }
  /// The costs from a stop to all stops.
  std::span<const double> row(int from) const {
    return {costs_.data() + index(from, 0), static_cast<std::size_t>(size_)};
  }
  /// All costs, row after row.
  std::span<const double> values() const { return costs_; }
  /// Are all costs the same both ways? O(stops^2).
  bool symmetric() const;

 private:
  std::size_t index(int from, int to) const {
    return static_cast<std::size_t>(from) * static_cast<std::size_t>(size_) +
           static_cast<std::size_t>(to);
  }

  int size_ = 0;
  std::vector<double> costs_;
};

}  // namespace wend
