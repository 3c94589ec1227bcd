#pragma once

// A sample of a BitGrid: some words of its rows, the same ones every time, to estimate what all of it is like.

#include <cstddef>
#include <cstdint>

#include "wend/map/bit_grid.hpp"

namespace wend {

inline constexpr std::uint32_t kSampledWords = 512;

/// Calls visit(y, i, on_map) for kSampledWords words i of rows y; the bits of on_map are cells of the map. They spread
/// evenly, and small grids give some of them more than once.
template <class Visit>
void visit_sample(const BitGrid& grid, Visit&& visit) {
  constexpr std::uint32_t kGoldenRatio = 0x9E3779B9U;  // of 2^32: its multiples spread evenly
  const auto last_bit = static_cast<std::size_t>(grid.width());
  const std::size_t columns = last_bit / 64 + 1;
  const std::uint64_t words = std::uint64_t{columns} * static_cast<std::uint64_t>(grid.height());
  for (std::uint32_t k = 0; k < kSampledWords; ++k) {
    const std::uint64_t word = (std::uint64_t{k * kGoldenRatio} * words) >> 32U;
    const std::size_t i = word % columns;
    std::uint64_t on_map = i == 0 ? ~std::uint64_t{1} : ~std::uint64_t{0};
    if (i == last_bit / 64) on_map &= ~std::uint64_t{0} >> (63 - last_bit % 64);
    visit(static_cast<int>(word / columns), i, on_map);
  }
}

}  // namespace wend
