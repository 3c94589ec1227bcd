#pragma once

// CappedDistances: the distances of distance_field.hpp as far as a robot needs them.
//
// They are exact up to a cap of some cells; what is farther is only "far". So they take 2 bytes for each
// cell, are computed 8 or more cells at a time, and an edit of the map changes them only near itself.

#include <cstdint>

#include "wend/base/deadline.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"

namespace wend {

class CappedDistances {
 public:
  /// The largest cap, in cells: for it, sums of two squares fit 16 bits.
  static constexpr int kLargestCap = 63;

  /// No cells.
  CappedDistances() = default;

  /// The distances from the centre of each cell to the nearest closed square of a set cell of `blocked`,
  /// or to the edge of the map if it counts. The cap is from 1 to kLargestCap. O(cells) and, where
  /// obstacles are far, O(cells * cap / 8).
  CappedDistances(const BitGrid& blocked, bool edge_counts, int cap,
                  DeadlineCheck& stop = DeadlineCheck::never());

  /// Are there no cells?
  bool empty() const { return squared_.empty(); }
  /// Distances are exact up to this many cells.
  int cap() const { return cap_; }

  /// The squared distance that stands for all that is farther, in half-cells: that of a square with
  /// `cap` cells between.
  std::uint32_t far() const { return static_cast<std::uint32_t>((2 * cap_ + 1) * (2 * cap_ + 1)); }

  /// The squared distance of a cell, in half-cells: exact if it is less than far(), else far().
  std::uint32_t operator[](Cell cell) const { return static_cast<std::uint32_t>(squared_[cell]); }

  /// The same for the cells of a row, from the first on.
  void read_row(int y, std::span<std::uint32_t> squared) const {
    const auto row = squared_.row(y);
    for (std::size_t x = 0; x < squared.size(); ++x)
      squared[x] = static_cast<std::uint32_t>(row[x]);
  }

  /// Computes the distances again that can have changed because cells in a box of the map did: those at
  /// most `cap` cells from it. Returns a box of those that changed. O(cells in reach).
  CellBox repair(const BitGrid& blocked, const CellBox& edited);

  /// Sets the bits in a box of the map: of the cells whose squared distance, in half-cells, is at least
  /// `least`, which is at most far().
  void select(std::uint32_t least, const CellBox& box, BitGrid& cells,
              DeadlineCheck& stop = DeadlineCheck::never()) const;

  friend bool operator==(const CappedDistances&, const CappedDistances&) = default;

 private:
  using Squared = std::int16_t;

  class Window;

  int cap_ = 0;
  bool edge_counts_ = false;
  Grid<Squared> squared_;
};

}  // namespace wend
