#pragma once

// CostUnits: what a step between two cells with costs is, in whole numbers.
//
// 577 / 408 is the square root of 2 to 1.1e-6, so a cheapest path in units costs at most that share more
// than the cheapest.

#include <cstdint>

#include "wend/map/cost_map.hpp"

namespace wend {

struct CostUnits {
  static constexpr std::uint64_t kStraight = 408;  // times the sum of the CostMap steps of both cells
  static constexpr std::uint64_t kDiagonal = 577;
  static constexpr double kUnitsPerCell = 2.0 * CostMap::kOne * kStraight;  // at a multiplier of 1
};

}  // namespace wend
