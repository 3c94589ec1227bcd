#pragma once

// ColumnTiles: the columns of a BitGrid as lines of bits, turned tile by tile when somebody first reads them.
//
// A tile is 64 x 64 bits. Cell (x, y) is bit y + 1 of line x + 1; the border of the grid can be read, too. A
// search that stays in a corner of a large map touches the memory of that corner only.
//
//   wend::ColumnTiles columns(passable);
//   columns.prepare({3, 4});  // before what lies around the cell is read
//   const bool free = (columns.line(3)[(4 + 1) / 64] >> (4 + 1) % 64 & 1U) != 0;
//
// One thread. A bit per cell where it was read, and two bytes per tile.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

class ColumnTiles {
 public:
  /// `bits` must live as long. O(tiles).
  explicit ColumnTiles(const BitGrid& bits);

  /// Makes the tile of a cell of the grid and those around it readable.
  [[gnu::always_inline]] void prepare(Cell cell) {
    const std::size_t tile = static_cast<std::size_t>(cell.x + 1) / 64 * line_words_ +
                             static_cast<std::size_t>(cell.y + 1) / 64;
    if (prepared_[tile] == 0) [[unlikely]]
      prepare_around(tile);
  }

  /// Turns the tiles of a box of the grid anew when they are next prepared.
  void forget(const CellBox& box);

  /// The words of a column, which may lie one outside.
  const std::uint64_t* line(int x) const {
    return words_.get() + static_cast<std::size_t>(x + 1) * line_words_;
  }

 private:
  [[gnu::noinline]] void prepare_around(std::size_t tile);
  template <class Visit>
  void visit_around(std::size_t tile, Visit&& visit);
  void turn(std::size_t tile);

  const BitGrid* bits_;
  std::size_t line_words_;                  // also the number of tiles below each other
  std::vector<std::uint8_t> turned_;        // by tile: can it be read?
  std::vector<std::uint8_t> prepared_;      // and those around it?
  std::unique_ptr<std::uint64_t[]> words_;  // not touched before they are turned
};

}  // namespace wend
