#pragma once

// Turns: where a shortest path turns around an obstacle, and how it comes there.
//
// A turn is a cell and the straight direction d in which a path arrives there, where on a side e
// the next cell is passable and the one behind that is blocked:
//
//     # e           the path comes from the left; it could not have gone to e earlier
//     > T
//
// A shortest path can be drawn diagonally first: while somewhere a straight step is followed by a
// diagonal one and the two can change places, they do. What is left has few shapes. A straight step
// and a diagonal step, or straight steps at a right angle, follow each other only at a turn, for
// elsewhere they can change places, or a single diagonal step is shorter. After a diagonal step
// come the same one or one of its two straight parts: all else is longer than going straight. So
// the path is a chain of legs, each some diagonal steps and then some straight ones (either may be
// missing), joined at turns; and a leg from the turn (T, d) goes straight on, or to a side e of the
// turn, or first along the diagonal between d and e. (The jump points of D. Harabor and A. Grastien,
// "Online Graph Pruning for Pathfinding on Grid Maps", 2011, without those on diagonals; as a graph
// they are those of D. Harabor, T. Uras, P. Stuckey and S. Koenig, "Regarding Jump Point Search and
// Subgoal Graphs", 2019.)
//
// That gives a directed graph of turns, which is sparse even where corners see many others: a path
// that arrives in one direction has few ways to go on. Boards have y down: see drawn_board.hpp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/index/corners.hpp"
#include "wend/index/diagonal_walk.hpp"
#include "wend/index/octile_cost.hpp"
#include "wend/index/rays.hpp"

namespace wend {

/// By a set of 8 bits: for each straight direction d/2 whether a path that arrives that way turns
/// to the next straight direction counter-clockwise (bit 2 d/2), or clockwise (the bit after).
/// `block` is BitGrid::block(cell, 1).
unsigned turn_sides(unsigned block);

class Turns {
 public:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  /// O(cells).
  explicit Turns(const BitGrid& passable);

  const BitGrid& passable() const { return corners_.passable(); }
  std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
  Cell cell(std::uint32_t turn) const { return cells_[turn]; }

  /// Is the way free that goes diagonally first?
  bool sees(Cell from, Cell to) const;

  /// visit(turn, cost) of each turn that a path from a passable cell may come to first.
  template <class Visit>
  void for_each_first(Cell from, Visit&& visit) const;

  /// visit(turn, cost) of each turn that a path may come to next.
  template <class Visit>
  void for_each_next(std::uint32_t turn, Visit&& visit) const;

  /// visit(turn, cost) of each turn that a path to a passable cell may come to last. Some may be
  /// visited twice.
  template <class Visit>
  void for_each_last(Cell to, Visit&& visit) const;

 private:
  using Straight = unsigned;  // Direction / 2; with a diagonal between each and the next

  static constexpr Straight left_of(Straight straight) { return (straight + 1) % 4; }
  static constexpr Straight right_of(Straight straight) { return (straight + 3) % 4; }
  static constexpr unsigned left_side(Straight straight) { return 1U << (2 * straight); }
  static constexpr unsigned right_side(Straight straight) { return 2U << (2 * straight); }

  unsigned sides(Cell cell) const { return turn_sides(passable().block(cell, 1)); }
  std::uint32_t number(Cell cell, unsigned sides, Straight straight) const;

  template <class Visit>
  void visit_ray(Cell from, Straight straight, CornerCost cost, Visit&& visit) const;
  template <class Visit>
  void visit_diagonal(Cell from, unsigned diagonal, Visit&& visit) const;
  template <class Visit>
  void visit_turns_before(Cell cell, unsigned diagonal, CornerCost cost, Visit&& visit) const;

  Corners corners_;
  Rays rays_;
  std::vector<std::uint32_t> first_;  // by corner: its first turn
  std::vector<Cell> cells_;           // by turn
  std::vector<std::uint8_t> straights_;
};

template <class Visit>
void Turns::visit_ray(Cell from, Straight straight, CornerCost cost, Visit&& visit) const {
  const Cell end = rays_.end(from, kStraightDirections[straight]);
  if (!passable()[end]) return;
  visit(number(end, sides(end), straight), cost + octile_cost(from, end));
}

template <class Visit>
void Turns::visit_diagonal(Cell from, unsigned diagonal, Visit&& visit) const {
  walk_diagonal(passable(), from, kDiagonalDirections[diagonal], [&](Cell cell) {
    const CornerCost cost = octile_cost(from, cell);
    visit_ray(cell, diagonal, cost, visit);
    visit_ray(cell, left_of(diagonal), cost, visit);
    return true;
  });
}

template <class Visit>
void Turns::for_each_first(Cell from, Visit&& visit) const {
  for (Straight straight = 0; straight < 4; ++straight) visit_ray(from, straight, 0, visit);
  for (unsigned diagonal = 0; diagonal < 4; ++diagonal) visit_diagonal(from, diagonal, visit);
}

template <class Visit>
void Turns::for_each_next(std::uint32_t turn, Visit&& visit) const {
  const Cell from = cells_[turn];
  const Straight straight = straights_[turn];
  const unsigned turning = sides(from);
  visit_ray(from, straight, 0, visit);
  if ((turning & left_side(straight)) != 0) {
    visit_ray(from, left_of(straight), 0, visit);
    visit_diagonal(from, straight, visit);
  }
  if ((turning & right_side(straight)) != 0) {
    visit_ray(from, right_of(straight), 0, visit);
    visit_diagonal(from, right_of(straight), visit);
  }
}

/// The turns at a cell after which a path may go along a diagonal.
template <class Visit>
void Turns::visit_turns_before(Cell cell, unsigned diagonal, CornerCost cost, Visit&& visit) const {
  const unsigned turning = sides(cell);
  const Straight left = left_of(diagonal);
  if ((turning & left_side(diagonal)) != 0) visit(number(cell, turning, diagonal), cost);
  if ((turning & right_side(left)) != 0) visit(number(cell, turning, left), cost);
}

template <class Visit>
void Turns::for_each_last(Cell to, Visit&& visit) const {
  const auto visit_diagonals = [&](Cell cell, unsigned diagonal) {
    const Direction back = opposite(kDiagonalDirections[diagonal]);
    walk_diagonal(passable(), cell, back, [&](Cell before) {
      visit_turns_before(before, diagonal, octile_cost(before, to), visit);
      return true;
    });
  };
  for (unsigned diagonal = 0; diagonal < 4; ++diagonal) visit_diagonals(to, diagonal);
  for (Straight straight = 0; straight < 4; ++straight) {
    const Cell ahead = kDrawnSteps[static_cast<std::size_t>(kStraightDirections[straight])];
    for (Cell cell = to;;) {
      const unsigned turning = sides(cell);
      if ((turning & (left_side(straight) | right_side(straight))) != 0) {
        visit(number(cell, turning, straight), octile_cost(cell, to));
        break;  // what comes from farther away in this direction comes through that turn
      }
      cell = {cell.x - ahead.x, cell.y - ahead.y};
      if (!passable()[cell]) break;
      const unsigned turning_here = sides(cell);
      const Straight left = left_of(straight);
      const Straight right = right_of(straight);
      const CornerCost cost = octile_cost(cell, to);
      if ((turning_here & right_side(left)) != 0) visit(number(cell, turning_here, left), cost);
      if ((turning_here & left_side(right)) != 0) visit(number(cell, turning_here, right), cost);
      visit_diagonals(cell, straight);
      visit_diagonals(cell, right);
    }
  }
}

}  // namespace wend
