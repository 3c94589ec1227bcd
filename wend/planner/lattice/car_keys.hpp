#pragma once

// Keys and frontiers of searches for a car: f, then the larger g. Whole numbers go into buckets,
// real ones into a heap.

#include <cstdint>
#include <type_traits>

#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/space/lattice/car_space.hpp"

namespace wend {

template <class Cost>
using CarKey = std::conditional_t<std::is_integral_v<Cost>, ExactKey<Cost>, RealKey<Cost>>;

/// A move raises f by at most twice its cost, at most 10 turns: the ring's 256 buckets hold that.
inline constexpr unsigned kCarBucketBits = 12;
static_assert(2 * static_cast<std::uint64_t>(kMostWholeMultiplier) * CarUnits::kTurn <
              (std::uint64_t{256} << kCarBucketBits));

template <class Cost>
using CarFrontier =
    std::conditional_t<std::is_integral_v<Cost>, BucketFrontier<CarKey<Cost>, kCarBucketBits>,
                       HeapFrontier<CarKey<Cost>>>;

/// Keys grow by less than this between two looks, of 256 expansions.
template <class Cost>
bool near_overflow_of(const ExactKey<Cost>& key) {
  constexpr std::uint64_t kMargin = std::uint64_t{1} << 28U;
  return sizeof(Cost) == sizeof(std::uint32_t) && key.f() > UINT32_MAX - kMargin;
}
template <class Cost>
bool near_overflow_of(const RealKey<Cost>& /*key*/) {
  return false;
}

}  // namespace wend
