#pragma once

// Sight: is the way between two cells free that takes its diagonal steps first and its straight ones
// after them?
//
// A few words of bits a question: along rows and columns the passable cells, along both diagonals
// the squares of 2 x 2 passable cells, for a diagonal step that cuts no corner needs all four.
// Immutable.

#include "wend/geometry/cell.hpp"
#include "wend/jump/bit_lines.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

class Sight {
 public:
  /// O(cells); half a byte a cell, and a fourth of a byte for each in a square around the map.
  explicit Sight(const BitGrid& passable);

  /// The passable cells, by rows and by columns.
  const BitLines& rows() const { return rows_; }
  const BitLines& columns() const { return columns_; }

  /// From a passable cell; the other one is any of the map.
  bool sees(Cell from, Cell to) const;

 private:
  bool diagonal_is_free(Cell from, Cell to) const;
  bool straight_is_free(Cell from, Cell to) const;

  BitLines rows_;
  BitLines columns_;
  BitLines falling_right_;  // squares by their left upper cell
  BitLines falling_left_;
};

}  // namespace wend
