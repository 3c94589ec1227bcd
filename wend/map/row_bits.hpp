#pragma once

// row_bits(): some cells of a row of a BitGrid as the bits of a number, for loops over parts of rows.

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

}  // namespace wend
