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
// Immutable. O(cells) to make, some 26 bits a cell.

#include <array>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/jump/bit_lines.hpp"
#include "wend/jump/sight.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"

namespace wend {

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

  /// How many steps a straight run makes before it stops: at a jump point if moves() says so, else
  /// the step would be into a blocked cell.
  template <Direction kStraight>
  int distance_to_stop(Cell from) const {
    const BitLines& stops = stops_[quarter(kStraight)];
    if constexpr (kStraight == Direction::plus_y) return stops.distance_ahead(from.x, from.y);
    if constexpr (kStraight == Direction::plus_x) return stops.distance_ahead(from.y, from.x);
    if constexpr (kStraight == Direction::minus_y) return stops.distance_back(from.x, from.y);
    if constexpr (kStraight == Direction::minus_x) return stops.distance_back(from.y, from.x);
  }

  /// The straight directions whose next stop is a jump point, and the diagonal ones in which a step
  /// is legal.
  DirectionSet moves(Cell cell) const { return moves_[cell]; }

  /// How many steps a diagonal run makes before it stops: where one of its straight directions has a
  /// ray, or at its last cell. The first step must be legal.
  template <Direction kDiagonal>
  int distance_to_diagonal_stop(Cell from) const {
    const BitLines& stops = diagonal_stops_[quarter(kDiagonal)];
    const int line = diagonal_line(diagonals_along(kDiagonal), from, height());
    if constexpr (kDiagonal == Direction::plus_x_plus_y || kDiagonal == Direction::minus_x_plus_y) {
      return stops.distance_ahead(line, from.y);
    } else {
      return stops.distance_back(line, from.y);
    }
  }

  /// The jump points of all four directions, by rows. O(cells).
  BitLines jump_points() const;

 private:
  Sight sight_;
  std::array<BitLines, 4> stops_;           // by quarter(); by columns or rows
  std::array<BitLines, 4> diagonal_stops_;  // by quarter(); by diagonals
  Grid<DirectionSet> moves_;
};

}  // namespace wend
