#pragma once

// Integers for the two step lengths of a uniform grid, 1 and sqrt(2).
//
// Each pair is a convergent of sqrt(2) (Pell numbers): sums of steps compare exactly like the true
// lengths as long as their counts of diagonal steps differ by less than kStraight, and equal sums mean
// equal counts. So equal paths have equal costs on every platform.

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "wend/geometry/cell.hpp"

namespace wend {

template <class Cost>
struct OctileUnits;

/// For paths of up to some 128,000 cells.
template <>
struct OctileUnits<std::uint32_t> {
  static constexpr std::uint32_t kStraight = 33461;
  static constexpr std::uint32_t kDiagonal = 47321;
};

/// For paths of any length.
template <>
struct OctileUnits<std::uint64_t> {
  static constexpr std::uint64_t kStraight = 1311738121;
  static constexpr std::uint64_t kDiagonal = 1855077841;
};

// The octile path between two cells: diagonal steps first, then straight ones. No path is shorter, and
// without obstacles its length is the cost of a path between them.

/// The number of steps of each kind in the octile path.
struct OctileWay {
  int straight;
  int diagonal;
};

inline OctileWay octile_way(Cell from, Cell to) {
  const int wide = std::abs(to.x - from.x);
  const int high = std::abs(to.y - from.y);
  return {std::abs(wide - high), std::min(wide, high)};
}

/// How many steps of each kind have a cost in OctileUnits<std::uint64_t>: fewer than kStraight of them.
/// kDiagonal squared is -1 modulo kStraight, as the pair is a convergent of sqrt(2): so it is, but for the
/// sign, its own inverse.
constexpr std::uint64_t steps_of_cost(std::uint64_t cost) {
  using Units = OctileUnits<std::uint64_t>;
  constexpr std::uint64_t kRest = Units::kDiagonal % Units::kStraight;
  constexpr bool kNegative = kRest * kRest % Units::kStraight == Units::kStraight - 1;
  static_assert(kNegative || kRest * kRest % Units::kStraight == 1);
  constexpr std::uint64_t kInverse = kNegative ? Units::kStraight - kRest : kRest;
  const std::uint64_t diagonal = cost % Units::kStraight * kInverse % Units::kStraight;
  return diagonal + (cost - diagonal * Units::kDiagonal) / Units::kStraight;
}

/// The cost of the octile path, in OctileUnits<Cost>.
template <class Cost>
Cost octile_cost(Cell from, Cell to) {
  using Units = OctileUnits<Cost>;
  const auto dx = static_cast<Cost>(std::abs(to.x - from.x));
  const auto dy = static_cast<Cost>(std::abs(to.y - from.y));
  constexpr Cost kSaved = 2 * Units::kStraight - Units::kDiagonal;  // by a diagonal step
  return Units::kStraight * (dx + dy) - kSaved * std::min(dx, dy);
}

/// The cell where the octile path turns from its diagonal part to its straight part.
inline Cell octile_bend(Cell from, Cell to) {
  const int diagonal = octile_way(from, to).diagonal;
  return {to.x < from.x ? from.x - diagonal : from.x + diagonal,
          to.y < from.y ? from.y - diagonal : from.y + diagonal};
}

}  // namespace wend
