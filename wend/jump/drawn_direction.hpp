#pragma once

// Directions on a map as drawn, row 0 on top: what searches that jump do with them.

#include <array>
#include <cstddef>
#include <cstdint>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/jump/bit_lines.hpp"

namespace wend {

/// A bit for each direction.
using DirectionSet = std::uint8_t;

constexpr DirectionSet set_of(Direction direction) {
  return static_cast<DirectionSet>(1U << static_cast<unsigned>(direction));
}

inline constexpr std::array<Direction, 4> kStraightDirections{Direction::down, Direction::right,
                                                              Direction::up, Direction::left};

inline constexpr std::array<Direction, 4> kDiagonalDirections{
    Direction::down_right, Direction::up_right, Direction::up_left, Direction::down_left};

/// The number of a straight direction among the straight ones, of a diagonal one among its own.
constexpr std::size_t quarter(Direction direction) {
  return static_cast<std::size_t>(direction) / 2;
}

/// The direction so many eighths of a turn counter-clockwise, as drawn.
constexpr Direction turned(Direction direction, int eighths) {
  return static_cast<Direction>(
      (static_cast<unsigned>(direction) + kDirections + static_cast<unsigned>(eighths)) %
      kDirections);
}

/// The two directions an eighth of a turn away.
constexpr std::array<Direction, 2> beside(Direction direction) {
  return {turned(direction, -1), turned(direction, 1)};
}

constexpr Cell moved(Cell cell, Direction direction, int steps) {
  const Cell step = kDrawnSteps[static_cast<std::size_t>(direction)];
  return {cell.x + steps * step.x, cell.y + steps * step.y};
}

/// On which lines of cells a diagonal direction runs.
constexpr BitLines::Diagonals diagonals_along(Direction diagonal) {
  return diagonal == Direction::down_right || diagonal == Direction::up_left
             ? BitLines::Diagonals::falling_right
             : BitLines::Diagonals::falling_left;
}

}  // namespace wend
