#pragma once

// ArrivalBoards: bit boards for the backward search from a goal; they find where the last leg may begin.
//
// A leg goes diagonally first, then straight. Followed back from its end, it goes straight and then
// along a diagonal. So each straight direction has a board of the cells that matter on such a way back:
// corners, cells from which a diagonal back meets a beginning of legs, and blocked cells. Each diagonal
// direction has a board of the beginnings of legs and of the cells without a legal step back.
//
// Immutable. O(cells) to build, about 12 bits per cell.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/index/corner_cost.hpp"
#include "wend/index/corners.hpp"
#include "wend/index/index_building.hpp"
#include "wend/jump/bit_lines.hpp"
#include "wend/jump/jump_boards.hpp"

namespace wend {

class ArrivalBoards {
 public:
  ArrivalBoards(const Corners& corners, const JumpBoards& boards, const IndexBuilding& building);

  /// The number of steps back from a cell, against a direction of travel. Straight: to the next cell
  /// that matters. Diagonal: to a beginning of legs or to the last cell; the first step back must be
  /// legal.
  template <Direction kDirection>
  int distance_back(Cell from) const {
    const BitLines& stops = stops_[static_cast<std::size_t>(kDirection)];
    return distance_to_bit<opposite(kDirection)>(stops, from, height_);
  }

 private:
  int height_ = 0;
  std::array<BitLines, kDirections> stops_;  // as distance_to_bit() takes them
};

// Turns: where a shortest path turns around an obstacle, and in which direction it arrives there.
//
// A turn is a cell and the straight direction d in which a path arrives there. On a side e the neighbour
// is passable and the cell behind that neighbour is blocked:
//
//     # e           the path comes from the left; it could not have gone to e earlier
//     > T
//
// Every shortest path has a diagonal-first form: wherever a straight step can be swapped with a diagonal
// step that follows it, swap them. Few shapes remain. A straight and a diagonal step, or two straight
// steps at a right angle, follow each other only at a turn: elsewhere they can be swapped, or a single
// diagonal step is shorter. A diagonal step is followed by the same step or by one of its two straight
// parts; anything else is longer than going straight. So the path is a chain of legs joined at turns. A
// leg is some diagonal steps and then some straight steps (either part may be empty). From the turn
// (T, d) a leg goes straight on, or to a side e of the turn, or first along the diagonal between d and e.
// (The jump points of D. Harabor and A. Grastien, "Online Graph Pruning for Pathfinding on Grid Maps",
// 2011, without those on diagonals; as a graph they are those of D. Harabor, T. Uras, P. Stuckey and S.
// Koenig, "Regarding Jump Point Search and Subgoal Graphs", 2019.)
//
// The turns form a directed graph. It is sparse even where corners see many others, because a path that
// arrives in one direction has few ways to continue.

/// The turns at a cell towards one of these sides: a subset of turn_sides().
struct TurnChoice {
  Cell cell;
  unsigned sides = 0;
};

class Turns {
 public:
  /// O(cells).
  explicit Turns(const BitGrid& passable, const IndexBuilding& building = {});

  const BitGrid& passable() const { return corners_.passable(); }
  std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
  Cell cell(std::uint32_t turn) const { return cells_[turn]; }

  /// Is the path that goes diagonally first free?
  bool sees(Cell from, Cell to) const { return boards_.sight().sees(from, to); }

  /// Calls visit(turn) for each turn of a choice; there may be none.
  template <class Visit>
  void for_each_of(const TurnChoice& choice, Visit&& visit) const;

  /// Calls visit(choice, cost) for the turns that a path from a passable cell may reach first.
  template <class Visit>
  void for_each_first(Cell from, Visit&& visit) const;

  /// Calls visit(turn, cost) for each turn that a path may reach next.
  template <class Visit>
  void for_each_next(std::uint32_t turn, Visit&& visit) const;

  /// Calls visit(choice, cost) for the turns that a path to a passable cell may pass last.
  template <class Visit>
  void for_each_last(Cell to, Visit&& visit) const;

 private:
  static constexpr CornerCost kStraightCost = OctileUnits<CornerCost>::kStraight;
  static constexpr CornerCost kDiagonalCost = OctileUnits<CornerCost>::kDiagonal;

  static constexpr Direction left_of(Direction direction) { return turned(direction, 2); }
  static constexpr Direction right_of(Direction direction) { return turned(direction, -2); }
  static constexpr unsigned left_side(Direction straight) {
    return 1U << static_cast<unsigned>(straight);
  }
  static constexpr unsigned right_side(Direction straight) { return left_side(straight) << 1U; }
  static constexpr unsigned both_sides(Direction straight) {
    return left_side(straight) | right_side(straight);
  }

  /// Calls `visit` with std::integral_constant<Direction> for each straight direction.
  template <class Visit>
  static void for_each_straight(Visit&& visit) {
    using enum Direction;
    visit(std::integral_constant<Direction, plus_y>());
    visit(std::integral_constant<Direction, plus_x>());
    visit(std::integral_constant<Direction, minus_y>());
    visit(std::integral_constant<Direction, minus_x>());
  }

  unsigned sides(Cell cell) const { return turn_sides(passable().block(cell)); }

  std::uint32_t number(Cell cell, unsigned sides, Direction straight) const {
    const unsigned before = turning_straights(sides) & (left_side(straight) - 1);
    return first_[corners_.number(cell)] + static_cast<std::uint32_t>(std::popcount(before));
  }

  template <Direction kStraight, class Visit>
  void visit_ray(Cell from, CornerCost cost, Visit&& visit) const;
  template <Direction kDiagonal, class Visit>
  void visit_diagonal(Cell from, Visit&& visit) const;
  template <Direction kDiagonal, class Visit>
  void visit_back_on_diagonal(Cell from, CornerCost cost, Visit&& visit) const;
  template <Direction kStraight, class Visit>
  void visit_back(Cell from, Visit&& visit) const;

  Corners corners_;
  JumpBoards boards_;
  ArrivalBoards arrivals_;
  std::vector<std::uint32_t> first_;  // by corner: its first turn
  std::vector<Cell> cells_;           // by turn
  std::vector<Direction> straights_;
};

template <Direction kStraight, class Visit>
void Turns::visit_ray(Cell from, CornerCost cost, Visit&& visit) const {
  if ((boards_.moves(from) & set_of(kStraight)) == 0) return;
  const int steps = boards_.distance_to_stop<kStraight>(from);
  const Cell end = step(from, kStraight, steps);
  visit(TurnChoice{end, both_sides(kStraight)},
        cost + static_cast<CornerCost>(steps) * kStraightCost);
}

template <Direction kDiagonal, class Visit>
void Turns::visit_diagonal(Cell from, Visit&& visit) const {
  CornerCost cost = 0;
  while ((boards_.moves(from) & set_of(kDiagonal)) != 0) {
    const int steps = boards_.distance_to_stop<kDiagonal>(from);
    from = step(from, kDiagonal, steps);
    cost += static_cast<CornerCost>(steps) * kDiagonalCost;
    visit_ray<turned(kDiagonal, -1)>(from, cost, visit);
    visit_ray<turned(kDiagonal, 1)>(from, cost, visit);
  }
}

template <class Visit>
void Turns::for_each_of(const TurnChoice& choice, Visit&& visit) const {
  const unsigned turning = sides(choice.cell);
  unsigned straights = turning_straights(turning & choice.sides);
  for (; straights != 0; straights &= straights - 1) {
    visit(number(choice.cell, turning, static_cast<Direction>(std::countr_zero(straights))));
  }
}

template <class Visit>
void Turns::for_each_first(Cell from, Visit&& visit) const {
  for_each_straight([&](auto straight) {
    visit_ray<straight.value>(from, 0, visit);
    visit_diagonal<turned(straight.value, 1)>(from, visit);
  });
}

template <class Visit>
void Turns::for_each_next(std::uint32_t turn, Visit&& visit) const {
  const Cell from = cells_[turn];
  const unsigned turning = sides(from);
  const auto visit_choice = [&](const TurnChoice& choice, CornerCost cost) {
    for_each_of(choice, [&](std::uint32_t next) { visit(next, cost); });
  };
  for_each_straight([&](auto straight) {
    constexpr Direction kStraight = straight.value;
    if (straights_[turn] != kStraight) return;
    visit_ray<kStraight>(from, 0, visit_choice);
    if ((turning & left_side(kStraight)) != 0) {
      visit_ray<left_of(kStraight)>(from, 0, visit_choice);
      visit_diagonal<turned(kStraight, 1)>(from, visit_choice);
    }
    if ((turning & right_side(kStraight)) != 0) {
      visit_ray<right_of(kStraight)>(from, 0, visit_choice);
      visit_diagonal<turned(kStraight, -1)>(from, visit_choice);
    }
  });
}

/// Visits the turns from which a diagonal leads to this cell.
template <Direction kDiagonal, class Visit>
void Turns::visit_back_on_diagonal(Cell from, CornerCost cost, Visit&& visit) const {
  constexpr Direction kBack = opposite(kDiagonal);
  constexpr unsigned kSides = left_side(turned(kDiagonal, -1)) | right_side(turned(kDiagonal, 1));
  while ((boards_.moves(from) & set_of(kBack)) != 0) {
    const int steps = arrivals_.distance_back<kDiagonal>(from);
    from = step(from, kBack, steps);
    cost += static_cast<CornerCost>(steps) * kDiagonalCost;
    const bool last = (boards_.moves(from) & set_of(kBack)) == 0;
    if (!last || (sides(from) & kSides) != 0) visit(TurnChoice{from, kSides}, cost);
  }
}

/// Visits the turns from which a leg that ends with straight steps leads to this cell.
template <Direction kStraight, class Visit>
void Turns::visit_back(Cell from, Visit&& visit) const {
  constexpr unsigned kSides = right_side(left_of(kStraight)) | left_side(right_of(kStraight));
  unsigned turning = sides(from);
  CornerCost cost = 0;
  // A path from beyond a turn of this direction passes through that turn.
  while ((turning & both_sides(kStraight)) == 0) {
    const int steps = arrivals_.distance_back<kStraight>(from);
    from = step(from, opposite(kStraight), steps);
    if (!boards_.passable(from)) return;
    cost += static_cast<CornerCost>(steps) * kStraightCost;
    turning = sides(from);
    if ((turning & kSides) != 0) visit(TurnChoice{from, kSides}, cost);
    visit_back_on_diagonal<turned(kStraight, 1)>(from, cost, visit);
    visit_back_on_diagonal<turned(kStraight, -1)>(from, cost, visit);
  }
  visit(TurnChoice{from, both_sides(kStraight)}, cost);
}

template <class Visit>
void Turns::for_each_last(Cell to, Visit&& visit) const {
  for_each_straight([&](auto straight) {
    visit_back<straight.value>(to, visit);
    visit_back_on_diagonal<turned(straight.value, 1)>(to, 0, visit);
  });
}

}  // namespace wend
