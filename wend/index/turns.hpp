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
// that arrives in one direction has few ways to go on.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/index/arrival_boards.hpp"
#include "wend/index/corner_cost.hpp"
#include "wend/index/corners.hpp"
#include "wend/jump/jump_boards.hpp"

namespace wend {

constexpr unsigned compute_turn_sides(unsigned block) {
  const auto passable = [block](Cell at) { return (block >> (4 - 3 * at.y + at.x) & 1U) != 0; };
  unsigned sides = 0;
  for (unsigned straight = 0; straight < 4; ++straight) {
    const Cell ahead = kDirectionSteps[2 * straight];
    if (!passable({-ahead.x, -ahead.y})) continue;
    for (const unsigned turn : {1U, 3U}) {
      const Cell beside = kDirectionSteps[(2 * (straight + turn)) % kDirections];
      if (!passable(beside) || passable({beside.x - ahead.x, beside.y - ahead.y})) continue;
      sides |= (turn == 1 ? 1U : 2U) << (2 * straight);
    }
  }
  return sides;
}

inline constexpr auto kTurnSides = [] {
  std::array<std::uint8_t, 512> table{};
  for (unsigned block = 0; block < table.size(); ++block) {
    table[block] = static_cast<std::uint8_t>(compute_turn_sides(block));
  }
  return table;
}();

/// By a set of 8 bits: for each straight direction d/2 whether a path that arrives that way turns
/// to the next straight direction counter-clockwise (bit d), or clockwise (the bit after). `block`
/// is BitGrid::block(cell).
constexpr unsigned turn_sides(unsigned block) { return kTurnSides[block]; }

/// One bit a straight direction, where a pair of sides is not empty: at bits 0, 2, 4, 6.
constexpr unsigned turning_straights(unsigned sides) { return (sides | sides >> 1U) & 0x55U; }

/// The turns at a cell that turn to one of these sides: a subset of turn_sides().
struct TurnChoice {
  Cell cell;
  unsigned sides = 0;
};

class Turns {
 public:
  /// O(cells).
  explicit Turns(const BitGrid& passable);

  const BitGrid& passable() const { return corners_.passable(); }
  std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
  Cell cell(std::uint32_t turn) const { return cells_[turn]; }

  /// Is the way free that goes diagonally first?
  bool sees(Cell from, Cell to) const { return boards_.sight().sees(from, to); }

  /// visit(turn) of each turn of a choice: there may be none.
  template <class Visit>
  void for_each_of(const TurnChoice& choice, Visit&& visit) const;

  /// visit(choice, cost) of the turns that a path from a passable cell may come to first.
  template <class Visit>
  void for_each_first(Cell from, Visit&& visit) const;

  /// visit(turn, cost) of each turn that a path may come to next.
  template <class Visit>
  void for_each_next(std::uint32_t turn, Visit&& visit) const;

  /// visit(choice, cost) of the turns that a path to a passable cell may come to last.
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
    const int steps = boards_.distance_to_diagonal_stop<kDiagonal>(from);
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

/// The turns from which one comes here along a diagonal.
template <Direction kDiagonal, class Visit>
void Turns::visit_back_on_diagonal(Cell from, CornerCost cost, Visit&& visit) const {
  constexpr Direction kBack = opposite(kDiagonal);
  constexpr unsigned kSides = left_side(turned(kDiagonal, -1)) | right_side(turned(kDiagonal, 1));
  while ((boards_.moves(from) & set_of(kBack)) != 0) {
    const int steps = arrivals_.distance_back_on_diagonal<kDiagonal>(from);
    from = step(from, kBack, steps);
    cost += static_cast<CornerCost>(steps) * kDiagonalCost;
    const bool last = (boards_.moves(from) & set_of(kBack)) == 0;
    if (!last || (sides(from) & kSides) != 0) visit(TurnChoice{from, kSides}, cost);
  }
}

/// The turns from which one comes here by straight steps last, or by such steps alone.
template <Direction kStraight, class Visit>
void Turns::visit_back(Cell from, Visit&& visit) const {
  constexpr unsigned kSides = right_side(left_of(kStraight)) | left_side(right_of(kStraight));
  unsigned turning = sides(from);
  CornerCost cost = 0;
  // What comes from before a turn of this direction comes through that turn.
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
