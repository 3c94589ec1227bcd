#pragma once

// CostUnits: what a step between two cells with costs is, in whole numbers.
//
// 577 / 408 exceeds the square root of 2 by 1.5e-6 of it. So a path that is cheapest in units costs at most
// 1.5e-6 of the least cost more.

#include <cstdint>

#include "wend/map/cost_map.hpp"

namespace wend {

struct CostUnits {
  static constexpr double kMostExcess = 1.51e-6;  // of the least cost
  static constexpr std::uint64_t kStraight =
      408;  // times the sum of the CostMap steps of both cells
  static constexpr std::uint64_t kDiagonal = 577;
  static constexpr double kUnitsPerCell = 2.0 * CostMap::kOne * kStraight;  // at a multiplier of 1
};

}  // namespace wend
