#pragma once

// ColumnTiles: the columns of a BitGrid as words of bits, turned tile by tile when somebody first reads them.
//
// A tile is 64 x 64 bits. Place (x, y) of the grid is bit (y + 1) % 64 of the word column(x) + 64 rows of tiles
// down, so columns -1 and `width` and rows -1 and `height` can be read, too: the border of the grid. A search
// that stays in a corner of a large map touches the memory of that corner only.
//
//   wend::ColumnTiles columns(passable);
//   columns.prepare(3, (5 + 1) / 64);  // before a word is read
//   const std::uint64_t word = *columns.word(3, (5 + 1) / 64);
//
// One thread. A bit per cell where it was read, and a byte per tile.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "wend/map/bit_grid.hpp"

namespace wend {

class ColumnTiles {
 public:
  static constexpr std::ptrdiff_t kDown = 64;  // words from a word of a column to the next

  /// `bits` must live as long. O(tiles).
  explicit ColumnTiles(const BitGrid& bits);

  /// Makes the words of a column and of its neighbours in a row of tiles readable. `x` is a column of the
  /// grid.
  void prepare(int x, std::size_t tile_row) {
    const std::size_t before = tile(static_cast<std::size_t>(x), tile_row);
    const std::size_t behind = tile(static_cast<std::size_t>(x) + 2, tile_row);
    if (turned_[before] == 0) turn(before);
    if (turned_[behind] == 0) turn(behind);
  }

  /// The word of a column in a row of tiles. `x` may lie one outside.
  const std::uint64_t* word(int x, std::size_t tile_row) const {
    const auto place = static_cast<std::size_t>(x + 1);
    return words_.get() + tile(place, tile_row) * 64 + place % 64;
  }

 private:
  /// `place`: a column, counted from the border.
  std::size_t tile(std::size_t place, std::size_t tile_row) const {
    return place / 64 * tile_rows_ + tile_row;
  }
  [[gnu::noinline]] void turn(std::size_t tile);

  const BitGrid* bits_;
  std::size_t tile_rows_;
  std::vector<std::uint8_t> turned_;        // by tile: is it readable?
  std::unique_ptr<std::uint64_t[]> words_;  // 64 for each tile; not touched before it is turned
};

}  // namespace wend
