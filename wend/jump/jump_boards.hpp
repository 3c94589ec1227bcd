#pragma once

// JumpBoards: a map as bit boards on which a jump point search finds the next jump points.
//
// Steps go to the 8 neighbours and do not cut corners. A shortest path can always take its diagonal
// steps first and its straight steps after them, unless an obstacle makes it turn: a straight run passes
// a free cell beside it, and the cell behind that one is blocked. That cell of the run is a jump point
// for its direction of travel (D. Harabor and A. Grastien, "Online Graph Pruning for Pathfinding on Grid
// Maps", 2011; without cutting corners: "Improving Jump Point Search", 2014). Each straight direction
// has a board of the cells where a run stops (blocked cells and jump points), and one bit per cell that
// says whether the next stop is a jump point: a ray. A diagonal run matters only where one of its two
// straight directions has a ray, so it stops there, or at its last cell.
//
// O(cells) to build, about 26 bits per cell. An edit of the map changes only bits near it, and along the lines
// of cells that pass it: repair().

#include <array>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/jump/bit_lines.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"

namespace wend {

// Sight: is the path between two cells that takes its diagonal steps first, then its straight steps,
// free?
//
// A query reads a few words of bits: the passable cells along rows and columns, and the squares of 2 x 2
// passable cells along both diagonals, because a diagonal step without corner cutting needs all four.
// Immutable.

class Sight {
 public:
  /// O(cells); half a byte per cell, and a quarter of a byte for each cell in a square around the map.
  explicit Sight(const BitGrid& passable);

  /// The passable cells, by rows and by columns.
  const BitLines& rows() const { return rows_; }
  const BitLines& columns() const { return columns_; }

  /// `from` is passable; the other cell is any cell of the map.
  bool sees(Cell from, Cell to) const;

  /// Takes the cells of a box anew. O(cells of the box).
  void repair(const BitGrid& passable, const CellBox& box);

  friend bool operator==(const Sight&, const Sight&) = default;

 private:
  bool diagonal_is_free(Cell from, Cell to) const;
  bool straight_is_free(Cell from, Cell to) const;

  BitLines rows_;
  BitLines columns_;
  BitLines falling_right_;  // squares by their upper left cell
  BitLines falling_left_;
};

class JumpBoards {
 public:
  explicit JumpBoards(const BitGrid& passable);

  int width() const { return rows().length(); }
  int height() const { return rows().lines(); }

  /// The passable cells.
  const BitLines& rows() const { return sight_.rows(); }
  const Sight& sight() const { return sight_; }

  /// False outside the map, which must be no farther than one cell.
  bool passable(Cell cell) const { return rows().get(cell.y, cell.x); }

  /// The number of steps of a run before it stops. A straight run stops at a jump point if moves() says
  /// so, else before a blocked cell. A diagonal run, whose first step must be legal, stops where one of
  /// its straight directions has a ray, or at its last cell.
  template <Direction kDirection>
  int distance_to_stop(Cell from) const {
    return distance_to_bit<kDirection>(stops_[static_cast<std::size_t>(kDirection)], from,
                                       height());
  }

  /// Where runs in a direction stop, as distance_to_bit() takes them.
  const BitLines& stops(Direction direction) const {
    return stops_[static_cast<std::size_t>(direction)];
  }

  /// Is there a jump point before its end on the straight part of the path that Sight follows between two cells?
  /// For cells in sight.
  bool passes_jump(Cell from, Cell to) const;

  /// The straight directions whose next stop is a jump point, and the diagonal ones in which a step
  /// is legal.
  DirectionSet moves(Cell cell) const { return moves_[cell]; }

  /// The jump points of all four directions, by rows. O(cells).
  BitLines jump_points() const;

  /// Is the cell a jump point for any direction of travel?
  bool is_jump_point(Cell cell) const;

  /// Makes the boards those of a map that differs from theirs in these boxes of cells only.
  /// O(cells of the boxes and of the runs that pass them).
  void repair(const BitGrid& passable, std::span<const CellBox> boxes);

  friend bool operator==(const JumpBoards&, const JumpBoards&) = default;

 private:
  bool is_jump_point(Direction ahead, Cell cell) const;
  bool is_legal(Direction diagonal, Cell cell) const;
  bool stops_at(Direction direction, Cell cell) const;
  void set_stop(Direction direction, Cell cell, bool stops);
  void set_move(Direction direction, Cell cell, bool moves);
  void repair_rays(Direction ahead, const CellBox& around, std::vector<Cell>& changed);
  void repair_diagonal_stops(Cell cell);

  Sight sight_;
  std::array<BitLines, kDirections> stops_;  // as distance_to_bit() takes them
  Grid<DirectionSet> moves_;
};

}  // namespace wend
