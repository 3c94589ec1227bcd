#pragma once

// The eight directions of a grid as a picture shows them, in the one fixed order in which wend
// generates successors: down first, then counter-clockwise as drawn. Even ones are straight, odd
// ones diagonal.
//
// "Down" is +y on maps with y down and -y on maps with y up, so that the same picture gives the
// same search whatever its file format.

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/cell.hpp"

namespace wend {

enum class Direction : std::uint8_t {
  down,
  down_right,
  right,
  up_right,
  up,
  up_left,
  left,
  down_left,
};

inline constexpr int kDirections = 8;

/// The step of a direction where y grows downwards.
inline constexpr std::array<Cell, kDirections> kDrawnSteps{
    {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

constexpr bool is_diagonal(Direction direction) {
  return (static_cast<unsigned>(direction) & 1U) != 0;
}

constexpr Direction opposite(Direction direction) {
  return static_cast<Direction>((static_cast<unsigned>(direction) + 4U) % kDirections);
}

/// The neighbour of a cell in that direction.
constexpr Cell step(Cell cell, Direction direction, bool y_up) {
  const Cell drawn = kDrawnSteps[static_cast<std::size_t>(direction)];
  return {cell.x + drawn.x, y_up ? cell.y - drawn.y : cell.y + drawn.y};
}

/// "down", "down_right", ... as drawn.
constexpr std::string_view to_string(Direction direction) {
  constexpr std::array<std::string_view, kDirections> kNames{
      "down", "down_right", "right", "up_right", "up", "up_left", "left", "down_left"};
  return kNames[static_cast<std::size_t>(direction)];
}

/// The direction nearest to the way from one cell to another, which is another one.
inline Direction nearest_direction(Cell from, Cell to, bool y_up) {
  const double right = static_cast<double>(to.x) - from.x;
  const double down = (static_cast<double>(to.y) - from.y) * (y_up ? -1 : 1);
  const auto eighths = static_cast<int>(std::round(std::atan2(right, down) / (kPi / 4)));
  return static_cast<Direction>((eighths + kDirections) % kDirections);
}

/// The direction nearest to a heading in grid coordinates, in radians from +x towards +y.
inline Direction nearest_direction(double heading, bool y_up) {
  const auto eighths =
      static_cast<int>(std::round(normalized_angle(y_up ? -heading : heading) / (kPi / 4)));
  return static_cast<Direction>((static_cast<int>(Direction::right) - eighths + kDirections) %
                                kDirections);
}

}  // namespace wend
