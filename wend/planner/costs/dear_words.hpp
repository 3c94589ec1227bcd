#pragma once

// DearWords: the words of a CostGrid where cells cost different multiples of their length, row by row. Loops of few
// operations on arrays, of which compilers do four at a time.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/map/bit_grid.hpp"
#include "wend/planner/costs/cost_grid.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// Some cells of a row, with one more on both sides.
class DearRow {
 public:
  explicit DearRow(int cells) : steps_(static_cast<std::size_t>(cells) + 2), free_(steps_.size()) {}

  /// The steps of a cell, 0 where it is blocked. They start with the cell before the first.
  const std::uint32_t* steps() const { return steps_.data(); }
  /// Which are free of the cell before, the cell itself and the one behind: three bits.
  const std::uint32_t* free() const { return free_.data(); }

  /// Reads the cells from `first` on. Beyond the map all are blocked.
  void read(const FreeSpace& space, Cell first) {
    std::ranges::fill(steps_, 0);
    if (first.y >= 0 && first.y < space.height()) read_steps(space, first);
    for (std::size_t i = 1; i + 1 < steps_.size(); ++i) {
      free_[i] = bit_if(steps_[i - 1], 0) | bit_if(steps_[i], 1) | bit_if(steps_[i + 1], 2);
    }
  }

 private:
  static std::uint32_t bit_if(std::uint32_t steps, unsigned bit) {
    return static_cast<std::uint32_t>(steps != 0) << bit;
  }

  /// Sets the steps of at most 64 cells to 0 whose bits are not set: four at a time.
  static void keep(std::uint64_t bits, std::span<std::uint32_t> steps) {
    if (bits == ~std::uint64_t{0}) return;
    std::size_t i = 0;
    for (; i + 4 <= steps.size(); i += 4, bits >>= 4U) {
      const std::array<std::uint32_t, 4>& mask = kMasks[bits & 15U];
      for (std::size_t k = 0; k < 4; ++k) steps[i + k] &= mask[k];
    }
    for (; i < steps.size(); ++i, bits >>= 1U) steps[i] &= kMasks[bits & 1U][0];
  }

  void read_steps(const FreeSpace& space, Cell first) {
    const int begin = std::max(first.x - 1, 0);
    const int end = std::min(first.x - 1 + static_cast<int>(steps_.size()), space.width());
    const auto steps = std::span(steps_).subspan(static_cast<std::size_t>(begin - first.x + 1),
                                                 static_cast<std::size_t>(end - begin));
    space.costs().read_row(begin, first.y, steps);
    const auto passable = space.passable().row_words(first.y);
    for (std::size_t i = 0; i < steps.size(); i += 64) {
      const std::uint64_t free = bits_from(passable, static_cast<std::size_t>(begin) + 1 + i);
      keep(free, steps.subspan(i, std::min<std::size_t>(64, steps.size() - i)));
    }
  }

  /// For four bits, all bits of each word whose bit is set.
  static constexpr auto kMasks = [] {
    std::array<std::array<std::uint32_t, 4>, 16> masks{};
    for (std::size_t bits = 0; bits < masks.size(); ++bits) {
      for (std::size_t k = 0; k < 4; ++k) masks[bits][k] = (bits >> k & 1U) != 0 ? ~0U : 0U;
    }
    return masks;
  }();

  std::vector<std::uint32_t> steps_;
  std::vector<std::uint32_t> free_;
};

// By value: loops over references are not vectorised.
template <class Number>
Number least_of(Number a, Number b) {
  return b < a ? b : a;
}
template <class Number>
Number most_of(Number a, Number b) {
  return a < b ? b : a;
}

/// The words of the cells in a row, from three rows.
template <class Word>
class DearWords {
 public:
  explicit DearWords(int cells)
      : words_(static_cast<std::size_t>(cells)), least_(words_.size() + 2), most_(least_.size()) {}

  std::span<const Word> of(const DearRow& below, const DearRow& middle, const DearRow& above) {
    find_range(below.steps(), middle.steps(), above.steps());
    write(middle.steps() + 1, above.free() + 1, middle.free() + 1, below.free() + 1);
    return words_;
  }

 private:
  using Steps = const std::uint32_t*;

  /// The least steps less 1 and the most steps of the free cells in each column. (A blocked one counts as the largest
  /// least: 0 - 1 wraps.)
  void find_range(Steps below, Steps middle, Steps above) {
    std::uint32_t* const least = least_.data();
    std::uint32_t* const most = most_.data();
    const std::size_t size = least_.size();
    for (std::size_t i = 0; i < size; ++i) {
      least[i] = least_of(below[i] - 1, least_of(middle[i] - 1, above[i] - 1));
      most[i] = most_of(below[i], most_of(middle[i], above[i]));
    }
  }

  /// From the ranges of the cell before, the cell and the one behind.
  void write(Steps steps, Steps above, Steps middle, Steps below) {
    Word* const words = words_.data();
    const Steps least = least_.data();
    const Steps most = most_.data();
    const std::size_t size = words_.size();
    for (std::size_t i = 0; i < size; ++i) {
      const Word low = Word{least_of(least[i], least_of(least[i + 1], least[i + 2]))} + 1;
      const Word high = most_of(most[i], most_of(most[i + 1], most[i + 2]));
      // A CostClass: a word can hold nine times its steps.
      const Word kind = static_cast<Word>(low != high) + static_cast<Word>(5 * high > 9 * low);
      const Word beside = (middle[i] & 1U) | (middle[i] >> 1U & 2U);
      const Word free = above[i] | beside << 3U | Word{below[i]} << 5U;
      const Word word = Word{steps[i]} << CostMoves::kKeyBits | kind << 8U | free;
      words[i] = word & (Word{0} - static_cast<Word>(steps[i] != 0));
    }
  }

  std::vector<Word> words_;
  std::vector<std::uint32_t> least_;
  std::vector<std::uint32_t> most_;
};

}  // namespace wend
