#pragma once

// The runs of set cells in a row of a BitGrid.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wend {

/// Set cells [begin, end) of one row.
struct RowRun {
  int begin;
  int end;
};

/// The first cell from x on whose bit is `value`, or width. `words` are those of a row, in which
/// cell x is bit x+1.
inline int next_cell(std::span<const std::uint64_t> words, int x, int width, bool value) {
  const auto first = static_cast<std::size_t>(x) + 1;
  std::size_t word = first / 64;
  std::uint64_t bits = (value ? words[word] : ~words[word]) & (~std::uint64_t{0} << (first % 64));
  while (bits == 0) {
    if (++word == words.size()) return width;
    bits = value ? words[word] : ~words[word];
  }
  const auto found = static_cast<int>(word * 64) + std::countr_zero(bits) - 1;
  return std::min(found, width);
}

/// Calls take(run) for every run of a row, from left to right.
template <class Take>
void for_each_run(std::span<const std::uint64_t> words, int width, Take&& take) {
  for (int x = next_cell(words, 0, width, true); x < width;) {
    const int end = next_cell(words, x, width, false);
    take(RowRun{x, end});
    x = end < width ? next_cell(words, end, width, true) : width;
  }
}

}  // namespace wend
