#pragma once

// BitLines: lines of bits that are scanned many cells at a time: the rows of a map, its columns, or
// its diagonals.
//
// A border of zeros, one bit wide, surrounds the bits, so that neighbours are read without a test for
// the edge. A scan step reads eight bytes at once, wherever they begin, and counts zeros. (Blocks of
// bits for jumping: D. Harabor and A. Grastien, "Improving Jump Point Search", 2014.)

#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

/// 64 words of 64 bits.
using BitBlock = std::array<std::uint64_t, 64>;

/// Swaps bit i of word j with bit j of word i: ever smaller squares, 32 x 32, 16 x 16, ... 1 x 1. (H. Warren,
/// "Hacker's Delight", 7-3.)
void transpose(BitBlock& block);

class BitLines {
 public:
  BitLines() = default;

  /// All bits are zero.
  BitLines(int lines, int length);

  /// The rows of a grid.
  explicit BitLines(const BitGrid& bits);

  int lines() const { return lines_; }
  int length() const { return length_; }

  /// `line` and `at` may lie one outside.
  bool get(int line, int at) const {
    const std::size_t bit = bit_of(line, at);
    return ((words_[bit / kWordBits] >> (bit % kWordBits)) & 1U) != 0;
  }
  void set(int line, int at) {
    const std::size_t bit = bit_of(line, at);
    words_[bit / kWordBits] |= std::uint64_t{1} << (bit % kWordBits);
  }

  void reset(int line, int at) {
    const std::size_t bit = bit_of(line, at);
    words_[bit / kWordBits] &= ~(std::uint64_t{1} << (bit % kWordBits));
  }

  void assign(int line, int at, bool value) {
    if (value) {
      set(line, at);
    } else {
      reset(line, at);
    }
  }

  /// The distance from `at` to the next set bit after it; there must be one in the line or its
  /// border.
  int distance_ahead(int line, int at) const {
    std::size_t bit = bit_of(line, at) + 1;
    int distance = 1;
    for (;;) {
      const auto skip = static_cast<int>(bit % 8);
      const std::uint64_t window = load(bit / 8) >> skip;
      if (window != 0) return distance + std::countr_zero(window);
      bit += static_cast<std::size_t>(kWordBits - skip);
      distance += kWordBits - skip;
    }
  }

  /// The same towards smaller numbers.
  int distance_back(int line, int at) const {
    std::size_t bit = bit_of(line, at) - 1;
    int distance = 1;
    for (;;) {
      const auto skip = static_cast<int>(7 - bit % 8);
      const std::uint64_t window = load(bit / 8 - 7) << skip;
      if (window != 0) return distance + std::countl_zero(window);
      bit -= static_cast<std::size_t>(kWordBits - skip);
      distance += kWordBits - skip;
    }
  }

  /// Are `count` bits from `at` on set?
  bool all_set(int line, int at, int count) const {
    std::size_t bit = bit_of(line, at);
    while (count > 0) {
      const auto skip = static_cast<int>(bit % 8);
      const int read = kWordBits - skip;
      const std::uint64_t missing = ~(load(bit / 8) >> skip);
      if (count < read) return (missing & ((std::uint64_t{1} << count) - 1)) == 0;
      if ((missing << skip) != 0) return false;
      bit += static_cast<std::size_t>(read);
      count -= read;
    }
    return true;
  }

  /// The words of a line, its border included: bit `at` is bit at + 1 of them. `line` may lie one
  /// outside.
  std::span<const std::uint64_t> words(int line) const {
    return {words_.data() + word_of(line), words_per_line_};
  }
  std::span<std::uint64_t> words(int line) {
    return {words_.data() + word_of(line), words_per_line_};
  }

  /// The transpose: lines become places in lines and places become lines. O(bits), 64 x 64 bits at a
  /// time.
  BitLines transposed() const;

  /// Returns one line per diagonal of the grid with these rows, and one bit per row: cell (at, line)
  /// becomes bit `line` of line diagonal_line().
  enum class Diagonals { falling_right, falling_left };
  BitLines diagonals(Diagonals which) const;

  friend bool operator==(const BitLines&, const BitLines&) = default;

 private:
  static constexpr int kWordBits = 64;
  static constexpr std::size_t kSlackWords = 1;  // scans read up to eight bytes further

  std::uint64_t load(std::size_t byte) const {
    std::uint64_t window = 0;
    std::memcpy(&window, reinterpret_cast<const unsigned char*>(words_.data()) + byte,
                sizeof window);
    return window;
  }
  std::size_t word_of(int line) const {
    assert(line >= -1 && line <= lines_);
    return kSlackWords + static_cast<std::size_t>(line + 1) * words_per_line_;
  }
  std::size_t bit_of(int line, int at) const {
    return word_of(line) * kWordBits + static_cast<std::size_t>(at + 1);
  }

  int lines_ = 0;
  int length_ = 0;
  std::size_t words_per_line_ = 0;
  std::vector<std::uint64_t> words_;
};

/// The line of diagonals() that a cell lies on, in a grid with `rows` rows. Diagonals may begin
/// outside.
constexpr int diagonal_line(BitLines::Diagonals which, Cell cell, int rows) {
  return which == BitLines::Diagonals::falling_right ? cell.x - cell.y + rows - 1 : cell.x + cell.y;
}

/// The kind of diagonal lines that a diagonal direction follows.
constexpr BitLines::Diagonals diagonals_along(Direction diagonal) {
  return diagonal == Direction::plus_x_plus_y || diagonal == Direction::minus_x_minus_y
             ? BitLines::Diagonals::falling_right
             : BitLines::Diagonals::falling_left;
}

/// The line and the place in it of a cell on the lines that a direction follows: columns for steps along y, rows
/// for steps along x, and for diagonal steps the lines of diagonals() of a grid with this number of rows.
struct LinePlace {
  int line;
  int at;
};

constexpr LinePlace line_place(Direction direction, Cell cell, int rows) {
  const Cell way = kDirectionSteps[static_cast<std::size_t>(direction)];
  if (is_diagonal(direction)) {
    return {diagonal_line(diagonals_along(direction), cell, rows), cell.y};
  }
  return way.y == 0 ? LinePlace{cell.y, cell.x} : LinePlace{cell.x, cell.y};
}

/// Does a direction lead towards greater places of its lines?
constexpr bool leads_ahead(Direction direction) {
  const Cell way = kDirectionSteps[static_cast<std::size_t>(direction)];
  return way.y == 0 ? way.x > 0 : way.y > 0;
}

/// The number of steps from a cell to the next set bit in a direction, on the lines that it follows.
template <Direction kDirection>
int distance_to_bit(const BitLines& lines, Cell from, int rows) {
  const auto [line, at] = line_place(kDirection, from, rows);
  return leads_ahead(kDirection) ? lines.distance_ahead(line, at) : lines.distance_back(line, at);
}

/// A board of the same size as `board`, whose words are word_at(line, i).
template <class WordAt>
BitLines mapped(const BitLines& board, WordAt&& word_at) {
  BitLines made(board.lines(), board.length());
  for (int line = 0; line < board.lines(); ++line) {
    const auto words = made.words(line);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = word_at(line, i);
  }
  return made;
}

/// The bits of a board and all blocked cells, including those outside the map.
inline BitLines with_blocked(const BitLines& board, const BitLines& passable) {
  return mapped(board, [&](int line, std::size_t i) {
    return board.words(line)[i] | ~passable.words(line)[i];
  });
}

/// Word i of a line, shifted to the bits one place before (`at - 1`).
inline std::uint64_t bits_before(std::span<const std::uint64_t> words, std::size_t i) {
  return words[i] << 1U | (i > 0 ? words[i - 1] >> 63U : 0);
}

/// The same for the bits one place behind (`at + 1`).
inline std::uint64_t bits_behind(std::span<const std::uint64_t> words, std::size_t i) {
  return words[i] >> 1U | (i + 1 < words.size() ? words[i + 1] << 63U : 0);
}

}  // namespace wend
