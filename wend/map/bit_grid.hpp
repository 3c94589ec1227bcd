#pragma once

// BitGrid: one bit for every cell of a map, inside a border of zeros, so that hot loops read the
// neighbours of any cell without checking for the map's edge.

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/cell_box.hpp"

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

  /// Sets the bits in the words that a box of the map touches to the complement of another grid of this
  /// size. O(words).
  void assign_complement(const BitGrid& other, const CellBox& box);

  /// Appends a row of zeros and returns its words. O(width) amortized.
  std::span<std::uint64_t> append_row();

  /// Appends some rows of zeros.
  void append_rows(int count);

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

/// 64 bits of a row (BitGrid::row_words()) from a bit on; those after its last word are 0.
inline std::uint64_t bits_from(std::span<const std::uint64_t> row, std::size_t bit) {
  const std::size_t word = bit / 64;
  const std::size_t shift = bit % 64;
  std::uint64_t bits = row[word] >> shift;
  if (shift > 0 && word + 1 < row.size()) bits |= row[word + 1] << (64 - shift);
  return bits;
}

/// Sets the bits of cells x, x + 1, ... of a row (BitGrid::row_words()) to what the predicate says of their
/// values, 64 at a time. Returns how many cells lie before the first bit that changed and behind the last
/// one: if none did, all lie before.
template <class T, class Predicate>
std::pair<std::size_t, std::size_t> assign_row(std::span<std::uint64_t> words, int x,
                                               std::span<const T> values, Predicate&& is_set) {
  std::size_t before = values.size();
  std::size_t behind = 0;
  for (std::size_t i = 0; i < values.size();) {
    const std::size_t bit = static_cast<std::size_t>(x) + 1 + i;
    const std::size_t count = std::min(64 - bit % 64, values.size() - i);
    std::array<unsigned char, 64> flags{};
    for (std::size_t k = 0; k < count; ++k) flags[k] = is_set(values[i + k]) ? 1 : 0;
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < 64; k += 8) {
      std::uint64_t bytes = 0;  // of 0 or 1; the product gathers them in its highest byte
      std::memcpy(&bytes, flags.data() + k, sizeof bytes);
      bits |= (bytes * 0x0102040810204080U >> 56U) << k;
    }
    const std::uint64_t mask = (~std::uint64_t{0} >> (64 - count)) << (bit % 64);
    std::uint64_t& word = words[bit / 64];
    const std::uint64_t changed = ((word ^ bits << (bit % 64)) & mask) >> (bit % 64);
    word ^= changed << (bit % 64);
    if (changed != 0) {
      before = std::min(before, i + static_cast<std::size_t>(std::countr_zero(changed)));
      behind = values.size() - (i + 64 - static_cast<std::size_t>(std::countl_zero(changed)));
    }
    i += count;
  }
  return {before, behind};
}

/// Sets the bits of a row that is all false.
template <class T, class Predicate>
void set_row(std::span<std::uint64_t> words, std::span<const T> values, Predicate&& is_set) {
  assign_row(words, 0, values, is_set);
}

}  // namespace wend
