#pragma once

// ArrivalBoards: bit boards on which one looks back from a goal: where a last leg may have begun.
//
// A leg goes diagonally first, then straight. Seen from its end it goes back straight, and from
// some cell on along a diagonal. So for each straight direction there is a board with the cells at
// which such a way back is of interest: corners, cells from which a diagonal back meets a beginning
// of legs, and blocked cells; and for each diagonal direction one with the beginnings of legs and
// the cells from which there is no step back. Beginnings are told from outside.
//
// Immutable. O(cells) to make, some 12 bits a cell.

#include <array>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/jump/bit_lines.hpp"

namespace wend {

class ArrivalBoards {
 public:
  /// Of rows: by quarter(), where a leg may begin that goes along it.
  using Beginnings = std::array<BitLines, 4>;

  ArrivalBoards() = default;

  /// Of the passable cells and the corners, by rows.
  ArrivalBoards(const BitLines& rows, const BitLines& corners, const Beginnings& beginnings);

  /// How many steps one goes back from a cell, against a straight direction of travel, before there
  /// is something of interest.
  template <Direction kStraight>
  int distance_back(Cell from) const {
    const BitLines& stops = straight_[quarter(kStraight)];
    if constexpr (kStraight == Direction::plus_y) return stops.distance_back(from.x, from.y);
    if constexpr (kStraight == Direction::plus_x) return stops.distance_back(from.y, from.x);
    if constexpr (kStraight == Direction::minus_y) return stops.distance_ahead(from.x, from.y);
    if constexpr (kStraight == Direction::minus_x) return stops.distance_ahead(from.y, from.x);
  }

  /// The same against a diagonal direction: to a beginning of legs, or to the last cell. The first
  /// step back must be legal.
  template <Direction kDiagonal>
  int distance_back_on_diagonal(Cell from) const {
    const BitLines& stops = diagonal_[quarter(kDiagonal)];
    const int line = diagonal_line(diagonals_along(kDiagonal), from, height_);
    if constexpr (kDiagonal == Direction::plus_x_plus_y || kDiagonal == Direction::minus_x_plus_y) {
      return stops.distance_back(line, from.y);
    } else {
      return stops.distance_ahead(line, from.y);
    }
  }

 private:
  int height_ = 0;
  std::array<BitLines, 4> straight_;  // by quarter(); by columns or rows
  std::array<BitLines, 4> diagonal_;  // by quarter(); by diagonals
};

}  // namespace wend
