#pragma once

// JumpBoards: a map as bit boards on which a jump point search looks for where to go next.
//
// Steps go to the 8 neighbours and cut no corner. A shortest path can always take its diagonal
// steps first and its straight ones after them, unless an obstacle makes it turn: where a straight
// run passes a cell beside it that is free though the one behind that is blocked. Such a cell of
// the run is a jump point for its direction of travel (D. Harabor and A. Grastien, "Online Graph
// Pruning for Pathfinding on Grid Maps", 2011; without cutting corners: "Improving Jump Point
// Search", 2014). For each straight direction there is a board with the cells where a run stops,
// blocked ones or jump points, and one bit a cell that says whether the next stop is a jump point: a
// ray. A diagonal run is of interest where one of its two straight directions has such a ray, so it
// stops there, or at its last cell.
//
// The boards know cells as drawn, row 0 on top. Immutable. O(cells) to make, some 26 bits a cell.

#include <array>
#include <cstdint>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"
#include "wend/space/bit_lines.hpp"

namespace wend {

/// A bit for each direction.
using DirectionSet = std::uint8_t;

constexpr DirectionSet set_of(Direction direction) {
  return static_cast<DirectionSet>(1U << static_cast<unsigned>(direction));
}

/// The direction so many eighths of a turn counter-clockwise, as drawn.
constexpr Direction turned(Direction direction, int eighths) {
  return static_cast<Direction>(
      (static_cast<unsigned>(direction) + kDirections + static_cast<unsigned>(eighths)) %
      kDirections);
}

constexpr Cell moved(Cell cell, Direction direction, int steps) {
  const Cell step = kDrawnSteps[static_cast<std::size_t>(direction)];
  return {cell.x + steps * step.x, cell.y + steps * step.y};
}

class JumpBoards {
 public:
  explicit JumpBoards(const BitGrid& drawn);

  int width() const { return rows_.length(); }
  int height() const { return rows_.lines(); }

  /// The passable cells.
  const BitLines& rows() const { return rows_; }

  /// False outside the map, which must be no farther than one cell.
  bool passable(Cell cell) const { return rows_.get(cell.y, cell.x); }

  /// How many steps a straight run makes before it stops: at a jump point if moves() says so, else
  /// the step would be into a blocked cell.
  template <Direction kStraight>
  int distance_to_stop(Cell from) const {
    const BitLines& stops = stops_[static_cast<std::size_t>(kStraight) / 2];
    if constexpr (kStraight == Direction::down) return stops.distance_ahead(from.x, from.y);
    if constexpr (kStraight == Direction::right) return stops.distance_ahead(from.y, from.x);
    if constexpr (kStraight == Direction::up) return stops.distance_back(from.x, from.y);
    if constexpr (kStraight == Direction::left) return stops.distance_back(from.y, from.x);
  }

  /// The straight directions whose next stop is a jump point, and the diagonal ones in which a step
  /// is legal.
  DirectionSet moves(Cell cell) const { return moves_[cell]; }

  /// How many steps a diagonal run makes before it stops: where one of its straight directions has a
  /// ray, or at its last cell. The first step must be legal.
  template <Direction kDiagonal>
  int distance_to_diagonal_stop(Cell from) const {
    const BitLines& stops = diagonal_stops_[static_cast<std::size_t>(kDiagonal) / 2];
    if constexpr (kDiagonal == Direction::down_right || kDiagonal == Direction::down_left) {
      return stops.distance_ahead(diagonal_line<kDiagonal>(from), from.y);
    } else {
      return stops.distance_back(diagonal_line<kDiagonal>(from), from.y);
    }
  }

  /// The jump points of all four directions, by rows. O(cells).
  BitLines jump_points() const;

  /// Can one go from cell to cell by diagonal steps first and straight ones then?
  bool in_sight(Cell from, Cell to) const;

 private:
  template <Direction kDiagonal>
  int diagonal_line(Cell cell) const {
    constexpr bool kFallsRight =
        kDiagonal == Direction::down_right || kDiagonal == Direction::up_left;
    return kFallsRight ? cell.x - cell.y + height() - 1 : cell.x + cell.y;
  }

  BitLines rows_;                  // passable cells
  BitLines columns_;               // the same
  std::array<BitLines, 4> stops_;  // down, right, up, left: by columns or rows
  std::array<BitLines, 4>
      diagonal_stops_;    // down_right, up_right, up_left, down_left: by diagonals
  BitLines falls_right_;  // by diagonals: the step down_right is legal
  BitLines falls_left_;   // the step down_left
  Grid<DirectionSet> moves_;
};

}  // namespace wend
