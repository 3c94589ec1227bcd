#pragma once

// BitGrid: one bit for every cell of a map, inside a border of zeros, so that hot loops read the
// neighbours of any cell without checking for the map's edge.

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"

namespace wend {

class WEND_API BitGrid {
 public:
  /// No cells.
  BitGrid() = default;
  /// All bits false. The sizes are at least 0.
  BitGrid(int width, int height);

  /// The number of columns, without the border.
  int width() const { return width_; }
  /// The number of rows, without the border.
  int height() const { return height_; }

  /// Is the cell on the map? The border is not.
  bool contains(Cell cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.x < width_ && cell.y < height_;
  }

  /// The bit of a cell of the map or of the border around it (which is always false).
  bool operator[](Cell cell) const {
    assert(cell.x >= -1 && cell.y >= -1 && cell.x <= width_ && cell.y <= height_);
    const std::size_t bit = bit_index(cell.x);
    return ((words_[row_begin(cell.y) + bit / 64] >> (bit % 64)) & 1U) != 0;
  }

  /// Sets the bit of a cell of the map.
  void set(Cell cell, bool value) {
    assert(contains(cell));
    const std::size_t bit = bit_index(cell.x);
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    std::uint64_t& word = words_[row_begin(cell.y) + bit / 64];
    word = value ? word | mask : word & ~mask;
  }

  /// The 3 x 3 block around a cell: bits 0 to 2 are its left, middle and right cell in row
  /// y + 1, bits 3 to 5 in row y, bits 6 to 8 in row y - 1. O(1).
  unsigned block(Cell cell) const {
    assert(contains(cell));
    const auto x = static_cast<std::size_t>(cell.x);  // the bit of x-1: bit 0 is the border
    const auto row_bytes = static_cast<std::ptrdiff_t>(8 * words_per_row_);
    const unsigned char* const middle =
        reinterpret_cast<const unsigned char*>(words_.data()) + (cell.y + 1) * row_bytes + x / 8;
    const auto three = [shift = x % 8](const unsigned char* bytes) {
      std::uint16_t bits = 0;
      std::memcpy(&bits, bytes, sizeof bits);
      return (static_cast<unsigned>(bits) >> shift) & 7U;
    };
    return three(middle + row_bytes) | three(middle) << 3U | three(middle - row_bytes) << 6U;
  }

  /// The words of a row; rows -1 and `height` are valid too. Cell x is bit x+1; all bits outside the
  /// map are zero.
  std::span<const std::uint64_t> row_words(int y) const {
    return {words_.data() + row_begin(y), words_per_row_};
  }
  /// The same for writing: keep the bits outside the map zero.
  std::span<std::uint64_t> row_words(int y) {
    return {words_.data() + row_begin(y), words_per_row_};
  }

  /// The cells of the map whose bit is not set. O(cells / 64).
  BitGrid complement() const;

  /// Appends a row of zeros and returns its words. O(width) amortized.
  std::span<std::uint64_t> append_row();

  /// Makes room for `height` rows.
  void reserve_rows(int height);

  /// The number of set bits. O(cells / 64).
  std::size_t count() const;

  friend bool operator==(const BitGrid&, const BitGrid&) = default;

 private:
  static std::size_t bit_index(int x) { return static_cast<std::size_t>(x + 1); }
  std::size_t row_begin(int y) const { return static_cast<std::size_t>(y + 1) * words_per_row_; }

  int width_ = 0;
  int height_ = 0;
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> words_;
};

/// Sets the bits of the cells that satisfy the predicate in a row (BitGrid::row_words(), all false), 64
/// at a time.
template <class T, class Predicate>
void set_row(std::span<std::uint64_t> words, std::span<const T> values, Predicate&& is_set) {
  for (std::size_t x = 0; x < values.size(); ++x) {
    words[(x + 1) / 64] |= std::uint64_t{is_set(values[x])} << ((x + 1) % 64);
  }
}

}  // namespace wend
