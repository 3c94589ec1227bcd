#pragma once

// Whole numbers for the two step lengths of a uniform grid, 1 and sqrt(2).
//
// Both numbers of a pair are a convergent of sqrt(2) (Pell numbers): sums of steps compare exactly
// as the true lengths do while their counts of diagonal steps differ by less than kStraight, and
// equal sums mean equal counts. So equal paths have equal costs, on every platform.

#include <cstdint>

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

}  // namespace wend
