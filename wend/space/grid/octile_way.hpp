#pragma once

// The octile way between two cells: diagonal steps first, then straight ones. Nothing is shorter,
// and without obstacles it is what a path between them costs.

#include <algorithm>
#include <cstdlib>

#include "wend/geometry/cell.hpp"
#include "wend/space/grid/octile_units.hpp"

namespace wend {

/// How many steps of each kind it has.
struct OctileWay {
  int straight;
  int diagonal;
};

inline OctileWay octile_way(Cell from, Cell to) {
  const int wide = std::abs(to.x - from.x);
  const int high = std::abs(to.y - from.y);
  return {std::abs(wide - high), std::min(wide, high)};
}

/// What it costs, in OctileUnits<Cost>.
template <class Cost>
Cost octile_cost(Cell from, Cell to) {
  using Units = OctileUnits<Cost>;
  const auto dx = static_cast<Cost>(std::abs(to.x - from.x));
  const auto dy = static_cast<Cost>(std::abs(to.y - from.y));
  constexpr Cost kSaved = 2 * Units::kStraight - Units::kDiagonal;  // by a diagonal step
  return Units::kStraight * (dx + dy) - kSaved * std::min(dx, dy);
}

/// Where it turns from its diagonal part to its straight part.
inline Cell octile_bend(Cell from, Cell to) {
  const int diagonal = octile_way(from, to).diagonal;
  return {to.x < from.x ? from.x - diagonal : from.x + diagonal,
          to.y < from.y ? from.y - diagonal : from.y + diagonal};
}

}  // namespace wend
