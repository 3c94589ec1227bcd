#pragma once

// FieldNode: what CostField keeps of a cell, in one number: from the highest bit down its cost g in units, the sum
// of its diagonal steps, the move by which it was reached, and a 1. A cell that was not reached is 0.
//
// A step is one addition, and cells compare as their numbers do, for the lower bits matter only where costs are
// equal.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "wend/base/state_id.hpp"
#include "wend/space/grid/cost_units.hpp"

namespace wend {

/// For costs that outgrow a FieldNode of 64 bits.
__extension__ using WideFieldNumber = unsigned __int128;

/// Number is 64 bits, or WideFieldNumber. Units are those of CostField.
template <class Number, class Units>
class FieldNode {
  static constexpr unsigned kBits = 8 * sizeof(Number);
  static constexpr unsigned kMoveShift = 1;
  static constexpr unsigned kDiagonalShift = kMoveShift + kMoveBits;
  // A diagonal step costs kDiagonal for each that it adds to the sum, so the sum needs fewer bits than g.
  static constexpr unsigned kFewer = std::bit_width(std::uint64_t{Units::kDiagonal}) - 1;
  static constexpr unsigned kCostBits = std::min((kBits - kDiagonalShift + kFewer) / 2, 63U);
  static constexpr unsigned kCostShift = kBits - kCostBits;
  static constexpr Number kBelowCost = (Number{1} << kCostShift) - 1;
  static constexpr Number kMoveMask = Number{kNoMove} << kMoveShift;
  static constexpr std::array<Number, 2> kSteps{
      Number{Units::kStraight} << kCostShift,
      (Number{Units::kDiagonal} << kCostShift) + (Number{1} << kDiagonalShift)};

 public:
  /// Does every free cell cost the same?
  static constexpr bool kUniform = !std::is_same_v<Units, CostUnits>;
  /// The largest g; OctileUnits are exact for half of what their type holds.
  static constexpr std::uint64_t kMostCost =
      kUniform ? std::numeric_limits<std::remove_const_t<decltype(Units::kDiagonal)>>::max() / 2
               : (std::uint64_t{1} << kCostBits) - 1;

  /// Of a goal.
  static FieldNode start() { return FieldNode(kMoveMask | 1U); }

  bool reached() const { return bits_ != 0; }
  std::uint64_t g() const { return static_cast<std::uint64_t>(bits_ >> kCostShift); }
  /// g / 2^width_bits
  std::uint64_t bucket(unsigned width_bits) const { return g() >> width_bits; }
  /// The sum of the steps of the CostGrid at both ends of all diagonal steps.
  std::uint64_t diagonals() const {
    return static_cast<std::uint64_t>((bits_ & kBelowCost) >> kDiagonalShift);
  }
  Move arrival() const { return static_cast<Move>((bits_ & kMoveMask) >> kMoveShift); }

  /// After a step between cells with `sum` steps of the CostGrid, to a g of at most kMostCost.
  FieldNode after(std::uint64_t sum, unsigned direction) const {
    return FieldNode((bits_ & ~kMoveMask) + sum * kSteps[direction & 1U] +
                     (direction << kMoveShift));
  }

  /// Was the cell reached, at no higher cost?
  bool as_cheap_as(FieldNode other) const { return bits_ - 1 < (other.bits_ | kBelowCost); }

 private:
  explicit FieldNode(Number bits) : bits_(bits) {}

  Number bits_;
};

}  // namespace wend
