#pragma once

// Direction: a step from a cell to one of its eight neighbours. Heading: one of the four directions
// that a car on the corners of a grid can face.
//
// Both are in grid coordinates, independent of how the map is drawn. compass.hpp says which of them is
// up, and how people call it.
//
//   const wend::Cell next = wend::step({3, 4}, wend::Direction::plus_x);  // (4,4)
//   const wend::Cell ahead = wend::ahead(wend::Heading::minus_y);         // (0,-1)

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {

/// Directions in the fixed order in which wend generates successors. Even ones are straight, odd ones
/// diagonal. Each is an eighth of a turn after the previous one, from +y towards +x.
enum class Direction : std::uint8_t {
  plus_y,           // (0, 1)
  plus_x_plus_y,    // (1, 1)
  plus_x,           // (1, 0)
  plus_x_minus_y,   // (1, -1)
  minus_y,          // (0, -1)
  minus_x_minus_y,  // (-1, -1)
  minus_x,          // (-1, 0)
  minus_x_plus_y,   // (-1, 1)
};

inline constexpr int kDirections = 8;  // the number of directions

/// The step of each direction.
inline constexpr std::array<Cell, kDirections> kDirectionSteps{
    {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

/// The directions along one axis, in their order.
inline constexpr std::array<Direction, 4> kStraightDirections{
    Direction::plus_y, Direction::plus_x, Direction::minus_y, Direction::minus_x};

/// The other directions, in their order.
inline constexpr std::array<Direction, 4> kDiagonalDirections{
    Direction::plus_x_plus_y, Direction::plus_x_minus_y, Direction::minus_x_minus_y,
    Direction::minus_x_plus_y};

/// The index of a straight direction among the straight ones, or of a diagonal one among the diagonals.
constexpr std::size_t quarter(Direction direction) {
  return static_cast<std::size_t>(direction) / 2;
}

/// A bit for each direction.
using DirectionSet = std::uint8_t;

/// The set of one direction.
constexpr DirectionSet set_of(Direction direction) {
  return static_cast<DirectionSet>(1U << static_cast<unsigned>(direction));
}

/// Does a step in this direction change x and y?
constexpr bool is_diagonal(Direction direction) {
  return (static_cast<unsigned>(direction) & 1U) != 0;
}

/// The direction turned by `eighths` eighths of a turn, from +y towards +x.
constexpr Direction turned(Direction direction, int eighths) {
  return static_cast<Direction>(
      (static_cast<unsigned>(direction) + kDirections + static_cast<unsigned>(eighths)) %
      kDirections);
}

/// The direction of the step back.
constexpr Direction opposite(Direction direction) { return turned(direction, kDirections / 2); }

/// The two directions an eighth of a turn away.
constexpr std::array<Direction, 2> beside(Direction direction) {
  return {turned(direction, -1), turned(direction, 1)};
}

/// The cell `steps` steps away.
constexpr Cell step(Cell cell, Direction direction, int steps = 1) {
  const Cell step = kDirectionSteps[static_cast<std::size_t>(direction)];
  return {cell.x + steps * step.x, cell.y + steps * step.y};
}

/// The direction of a step to a neighbour.
constexpr Direction direction_of(Cell step) {
  using enum Direction;
  constexpr std::array<Direction, 9> kByStep{minus_x_minus_y, minus_y, plus_x_minus_y,
                                             minus_x,         {},      plus_x,
                                             minus_x_plus_y,  plus_y,  plus_x_plus_y};
  return kByStep[static_cast<std::size_t>(3 * (step.y + 1) + step.x + 1)];
}

/// The direction nearest to the way from one cell to a different one.
inline Direction nearest_direction(Cell from, Cell to) {
  const double x = static_cast<double>(to.x) - from.x;
  const double y = static_cast<double>(to.y) - from.y;
  const auto eighths = static_cast<int>(std::round(arc_tangent(x, y) / (kPi / 4)));
  return static_cast<Direction>((eighths + kDirections) % kDirections);
}

/// The direction nearest to a heading, in radians from +x towards +y.
inline Direction nearest_direction(double heading) {
  const auto eighths = static_cast<int>(std::round(normalized_angle(heading) / (kPi / 4)));
  return turned(Direction::plus_x, -eighths);
}

/// Where a car on a lattice vertex faces. The numbers are part of the state numbers of its lattice.
enum class Heading : std::uint8_t {
  minus_y = 0,  // -pi / 2 radians
  minus_x = 1,  // pi radians
  plus_x = 2,   // 0 radians
  plus_y = 3    // pi / 2 radians
};

inline constexpr int kHeadings = 4;  // the number of headings
/// All headings, in their order.
inline constexpr std::array<Heading, kHeadings> kAllHeadings{Heading::minus_y, Heading::minus_x,
                                                             Heading::plus_x, Heading::plus_y};

/// Is it minus_x or plus_x?
constexpr bool is_along_x(Heading heading) {
  return heading == Heading::minus_x || heading == Heading::plus_x;
}

/// The heading after half a turn.
constexpr Heading opposite(Heading heading) {
  return static_cast<Heading>(kHeadings - 1 - static_cast<int>(heading));
}

/// The heading after a quarter turn from +x towards +y, as angles grow.
constexpr Heading quarter_turned(Heading heading) {
  constexpr std::array<Heading, kHeadings> kNext{Heading::plus_x, Heading::minus_y, Heading::plus_y,
                                                 Heading::minus_x};
  return kNext[static_cast<std::size_t>(heading)];
}

/// The unit step ahead.
constexpr Cell ahead(Heading heading) {
  constexpr std::array<Cell, kHeadings> kAhead{{{0, -1}, {-1, 0}, {1, 0}, {0, 1}}};
  return kAhead[static_cast<std::size_t>(heading)];
}

/// The angle from +x towards +y: a multiple of pi / 2 in (-pi, pi].
WEND_API double radians_of(Heading heading);

/// The heading nearest to a finite angle.
WEND_API Heading nearest_heading(double radians);

/// The heading with exactly this angle, as radians_of() gives it; nothing for other angles.
WEND_API std::optional<Heading> exact_heading(double radians);

}  // namespace wend
