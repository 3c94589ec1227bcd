#pragma once

// Walks along a diagonal, step by step, without cutting corners.

#include <array>
#include <cstddef>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

inline constexpr std::array<Direction, 4> kStraightDirections{Direction::down, Direction::right,
                                                              Direction::up, Direction::left};

inline constexpr std::array<Direction, 4> kDiagonalDirections{
    Direction::down_right, Direction::up_right, Direction::up_left, Direction::down_left};

/// The two straight directions beside a diagonal one.
constexpr std::array<Direction, 2> straight_parts(Direction diagonal) {
  const auto number = static_cast<unsigned>(diagonal);
  return {static_cast<Direction>(number - 1), static_cast<Direction>((number + 1) % kDirections)};
}

/// Visits the cells after `from` until a step is not legal or `visit(cell)` says false.
template <class Visit>
void walk_diagonal(const BitGrid& passable, Cell from, Direction diagonal, Visit&& visit) {
  const Cell step = kDrawnSteps[static_cast<std::size_t>(diagonal)];
  for (Cell cell = from;;) {
    const Cell next{cell.x + step.x, cell.y + step.y};
    if (!passable[{next.x, cell.y}] || !passable[{cell.x, next.y}] || !passable[next]) return;
    if (!visit(next)) return;
    cell = next;
  }
}

}  // namespace wend
