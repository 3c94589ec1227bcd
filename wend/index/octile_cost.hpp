#pragma once

// The cost of the shortest way between two cells of a grid without obstacles, in the whole numbers
// of OctileUnits<std::uint32_t>.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "wend/geometry/cell.hpp"
#include "wend/space/octile_units.hpp"

namespace wend {

using CornerCost = std::uint32_t;

/// More than any cost, and small enough to add two of them.
inline constexpr CornerCost kUnreachedCost = std::numeric_limits<CornerCost>::max() / 2;

inline CornerCost octile_cost(Cell a, Cell b) {
  using Units = OctileUnits<CornerCost>;
  const auto dx = static_cast<CornerCost>(std::abs(a.x - b.x));
  const auto dy = static_cast<CornerCost>(std::abs(a.y - b.y));
  const CornerCost diagonal = std::min(dx, dy);
  return Units::kStraight * (std::max(dx, dy) - diagonal) + Units::kDiagonal * diagonal;
}

}  // namespace wend
