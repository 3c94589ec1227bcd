#pragma once

// ComponentTile: the 4-connected components of the cells of one tile of a map, by themselves.
//
// A tile is 64 rows of one word of a BitGrid. Each run of set cells in a row has a label, that of its
// component; a cell finds its run by counting the runs that begin before it.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"

namespace wend {

class WEND_API ComponentTile {
 public:
  /// The number of rows, and of columns: bits of a word.
  static constexpr int kSize = 64;

  /// One word for each row.
  using Words = std::array<std::uint64_t, kSize>;
  /// Labels of two tiles that are 4-connected: of this one, of the next one.
  using Links = std::vector<std::pair<std::uint16_t, std::uint16_t>>;

  /// Labels the set cells. O(rows + runs).
  void label_cells(const Words& words);

  /// The set cells.
  const Words& words() const { return words_; }

  /// The label of a cell of the map that lies in this tile: 0 if it is not set, else from 1 on. O(1).
  std::uint32_t label(Cell cell) const {
    return label_at(static_cast<std::size_t>(cell.y) % kSize,
                    (static_cast<unsigned>(cell.x) + 1) % kSize);
  }
  /// The same for a bit of a row of the tile.
  std::uint32_t label_at(std::size_t row, unsigned bit) const {
    const std::uint64_t word = words_[row];
    if ((word >> bit & 1U) == 0) return 0;
    const std::uint64_t begins = word & ~(word << 1U);
    const auto runs = std::popcount(begins << (kSize - 1 - bit));
    return labels_[first_runs_[row] + static_cast<std::size_t>(runs) - 1];
  }

  /// The number of labels.
  std::uint32_t label_count() const { return static_cast<std::uint32_t>(sizes_.size()); }
  /// The numbers of cells of the labels 1, 2, ...
  std::span<const std::uint16_t> sizes() const { return sizes_; }

  /// Computes the links to the tile with the next columns and that with the next rows; null where there
  /// is none.
  void link(const ComponentTile* right, const ComponentTile* above);
  /// The links to the tile with the next columns.
  const Links& right() const { return right_; }
  /// The links to the tile with the next rows.
  const Links& above() const { return above_; }

  /// How many labels the tiles before this one have, less 1: plus a label, its number on the map.
  std::uint32_t first_label() const { return first_label_; }
  /// Sets it.
  void set_first_label(std::uint32_t first_label) { first_label_ = first_label; }

 private:
  Words words_{};
  std::array<std::uint16_t, kSize> first_runs_{};  // by row: the number of its first run
  std::vector<std::uint16_t> labels_;              // by run
  std::vector<std::uint16_t> sizes_;               // by label, from 1 on
  Links right_;
  Links above_;
  std::uint32_t first_label_ = 0;
};

}  // namespace wend
