#pragma once

// CornerCost: the unit of costs in indexes, whole numbers of OctileUnits<std::uint32_t>.

#include <cstdint>
#include <limits>

#include "wend/index/index_engine.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

using CornerCost = std::uint32_t;

/// More than any cost, and small enough to add two of them.
inline constexpr CornerCost kUnreachedCost = std::numeric_limits<CornerCost>::max() / 2;

// The straight and diagonal steps that a cost in whole numbers consists of.

namespace octile_steps {

using Units = OctileUnits<CornerCost>;

/// The inverse of kDiagonal modulo kStraight.
constexpr CornerCost inverse_of_diagonal() {
  CornerCost inverse = 1;
  while (std::uint64_t{inverse} * Units::kDiagonal % Units::kStraight != 1) ++inverse;
  return inverse;
}

inline constexpr CornerCost kInverse = inverse_of_diagonal();

}  // namespace octile_steps

/// Below this the steps follow from the cost: the two lengths have no common factor.
inline constexpr CornerCost kCostsOfOneKindOfPath =
    octile_steps::Units::kStraight * octile_steps::Units::kDiagonal;

/// The steps of a path that costs less than kCostsOfOneKindOfPath.
inline OctileSteps octile_steps_of(CornerCost cost) {
  using octile_steps::Units;
  const auto diagonal =
      static_cast<std::uint32_t>(std::uint64_t{cost} * octile_steps::kInverse % Units::kStraight);
  return {(cost - Units::kDiagonal * diagonal) / Units::kStraight, diagonal};
}

}  // namespace wend
