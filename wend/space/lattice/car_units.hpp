#pragma once

// Whole numbers for the two lengths of a car's moves, 1 and pi / 2.
//
// Half of kStraight and of kTurn are a convergent of pi / 2 (33215 and 52174): sums of moves
// compare exactly as the true lengths do while their counts of turns differ by less than 33215, and
// equal sums mean equal counts. Both are even, so that the mean of two multipliers is whole, too.

#include <cstdint>

namespace wend {

/// In 32 bits: for paths of up to some 60,000 units.
struct CarUnits {
  static constexpr std::uint32_t kStraight = 2 * 33215;
  static constexpr std::uint32_t kTurn = 2 * 52174;
};

}  // namespace wend
