#pragma once

// Parts of a row of a BitGrid: its cells as the bits of a number, and whether any of them is set.

#include <cstddef>
#include <cstdint>
#include <span>

namespace wend {

/// The bits of `count` cells, 1 to 63, of a row (BitGrid::row_words()) from x on, the first one lowest. Cells right
/// of the map are 0; x is at least 0.
inline std::uint64_t row_bits(std::span<const std::uint64_t> row, int x, int count) {
  const auto first = static_cast<std::size_t>(x) + 1;  // behind the border
  const std::size_t word = first / 64;
  const std::size_t shift = first % 64;
  if (word >= row.size()) return 0;
  std::uint64_t bits = row[word] >> shift;
  if (shift != 0 && word + 1 < row.size()) bits |= row[word + 1] << (64 - shift);
  return bits & ((std::uint64_t{1} << count) - 1);
}

/// Is any of the cells of a row from `first` to `last` set? Both are on the map.
inline bool any_set(std::span<const std::uint64_t> row, int first, int last) {
  const auto begin = static_cast<std::size_t>(first) + 1;  // behind the border
  const auto end = static_cast<std::size_t>(last) + 1;
  const std::uint64_t from = ~std::uint64_t{0} << (begin % 64);
  const std::uint64_t to = ~std::uint64_t{0} >> (63 - end % 64);
  if (begin / 64 == end / 64) return (row[begin / 64] & from & to) != 0;
  if ((row[begin / 64] & from) != 0 || (row[end / 64] & to) != 0) return true;
  for (std::size_t i = begin / 64 + 1; i < end / 64; ++i) {
    if (row[i] != 0) return true;
  }
  return false;
}

}  // namespace wend
