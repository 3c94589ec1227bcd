#pragma once

// CostField: the cheapest cost of every cell to the nearest of some goals, by Dijkstra's algorithm in whole
// numbers.
//
// A bucket is at most as wide as the cheapest step, so the cells of a bucket are final when it comes up, in
// any order, and none is expanded again. So the nodes of a whole bucket can be fetched ahead. The moves that
// CostGrid leaves out reach most cells only once.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "wend/base/bucket_queue.hpp"
#include "wend/base/limits.hpp"
#include "wend/base/zeroed_memory.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/costs/field_node.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

/// Number is that of its FieldNodes: 64 bits, or WideFieldNumber where costs outgrow them. Units are CostUnits, or
/// OctileUnits where every cell costs the same, with which the costs are exact.
template <class Number, class Word, class Units>
class CostField {
 public:
  using Grid = CostGrid<Word>;

  /// `grid` must live as long as the field.
  explicit CostField(const Grid& grid)
      : grid_(grid),
        nodes_(zeroed_table<Node>(grid.state_count())),
        width_bits_(static_cast<unsigned>(std::bit_width(least_step())) - 1) {}

  /// False if there was no memory: then run() ends as out_of_memory.
  bool allocated() const { return nodes_ != nullptr; }

  /// Are there so few buckets between the cheapest and the dearest step that this is fast?
  static bool suits(const Grid& grid) {
    constexpr std::uint64_t kMostRatio = std::uint64_t{1} << 15U;
    return grid.most_steps() / grid.least_steps() < kMostRatio;
  }

  /// Computes the costs to the nearest of the goals, which are free. Ends as exhausted, as cost_overflow if
  /// Number is too small, or early by the limits.
  SearchOutcome run(std::span<const Cell> goals, const Limits& limits);

  const SearchMetrics& metrics() const { return metrics_; }

  bool reached(Cell cell) const { return node(cell).reached(); }
  /// The cost of a cell, with the exact square root of 2; infinite if it was not reached.
  double cost(Cell cell) const {
    const Node here = node(cell);
    if (!here.reached()) return std::numeric_limits<double>::infinity();
    const std::uint64_t diagonals = here.diagonals();
    const std::uint64_t straights = (here.g() - diagonals * Units::kDiagonal) / Units::kStraight;
    return (static_cast<double>(straights) + std::numbers::sqrt2 * static_cast<double>(diagonals)) /
           (2.0 * static_cast<double>(grid_.one()));
  }
  /// The cost of a reached cell in units.
  std::uint64_t units(Cell cell) const { return node(cell).g(); }
  /// Every reached cell costs less than this, in units.
  std::uint64_t bound() const { return bound_; }
  /// The move by which a cell was reached from the goal; kNoMove in a goal, and if it was not reached.
  Move arrival(Cell cell) const {
    return node(cell).reached() ? node(cell).arrival() : Move{kNoMove};
  }

 private:
  using Node = FieldNode<Number, Units>;

  static constexpr std::size_t kAhead = 16;  // nodes fetched ahead

  std::uint64_t least_step() const { return 2 * grid_.least_steps() * Units::kStraight; }
  std::uint64_t most_step() const { return 2 * grid_.most_steps() * Units::kDiagonal; }

  const Node& node(Cell cell) const { return nodes_[grid_.number(cell)]; }
  void drain(LimitCheck& check);
  [[gnu::always_inline]] inline void fetch_ahead(StateId id) const;
  void expand(StateId id);
  void reach(StateId id, Node node);

  const Grid& grid_;
  ZeroedTable<Node> nodes_;
  unsigned width_bits_;
  BucketQueue<StateId> queue_;
  std::vector<StateId> bucket_;  // the current one
  std::uint64_t bound_ = 0;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
  SearchMetrics metrics_;
};

extern template class CostField<std::uint64_t, std::uint32_t, CostUnits>;
extern template class CostField<std::uint64_t, std::uint64_t, CostUnits>;
extern template class CostField<WideFieldNumber, std::uint32_t, CostUnits>;
extern template class CostField<WideFieldNumber, std::uint64_t, CostUnits>;
extern template class CostField<std::uint64_t, std::uint32_t, OctileUnits<std::uint32_t>>;
extern template class CostField<WideFieldNumber, std::uint32_t, OctileUnits<std::uint64_t>>;

}  // namespace wend
