#pragma once

// Runs of set cells in the rows of a BitGrid, found a word at a time.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wend {

/// Set cells [begin, end) of one row.
struct RowRun {
  static constexpr std::uint32_t kNoComponent = UINT32_MAX;  // not yet numbered

  int begin;                               // the column of the first cell
  int end;                                 // the column behind the last cell
  std::uint32_t component = kNoComponent;  // numbered by the code that labels runs
};

/// The first cell from x on whose bit is `value`, or width. In `words`, the words of a row, cell x is
/// bit x+1.
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

/// The last set cell from x on to the left, if it is not left of `least`; else `least` - 1.
inline int previous_cell(std::span<const std::uint64_t> words, int x, int least) {
  const auto first = static_cast<std::size_t>(x) + 1;
  std::size_t word = first / 64;
  std::uint64_t bits = words[word] & (~std::uint64_t{0} >> (63 - first % 64));
  while (bits == 0) {
    if (word == 0 || static_cast<int>(64 * word) - 1 <= least) return least - 1;
    bits = words[--word];
  }
  const int found = static_cast<int>(64 * word + 63) - std::countl_zero(bits) - 1;
  return found < least ? least - 1 : found;
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
