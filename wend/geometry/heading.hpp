#pragma once

// Heading: the four ways in which a car on the corners of a grid can face, as a picture shows them.
// East is +x. North is up as drawn: -y on maps with y down, +y on maps with y up.
//
//   const wend::Heading heading = wend::parse_heading("E").value();
//   const wend::Cell ahead = wend::ahead(heading, /*y_up=*/false);  // (1, 0)

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "wend/geometry/cell.hpp"

namespace wend {

/// The numbers are those that people may type.
enum class Heading : std::uint8_t { north = 0, west = 1, east = 2, south = 3 };

inline constexpr int kHeadings = 4;
inline constexpr std::array<Heading, kHeadings> kAllHeadings{Heading::north, Heading::west,
                                                             Heading::east, Heading::south};

/// "N", "W", "E" or "S"
constexpr std::string_view to_string(Heading heading) {
  constexpr std::array<std::string_view, kHeadings> kLetters{"N", "W", "E", "S"};
  return kLetters[static_cast<std::size_t>(heading)];
}

/// A quarter turn to the right, as drawn.
constexpr Heading right_of(Heading heading) {
  constexpr std::array<Heading, kHeadings> kRight{Heading::east, Heading::north, Heading::south,
                                                  Heading::west};
  return kRight[static_cast<std::size_t>(heading)];
}

constexpr Heading opposite(Heading heading) { return right_of(right_of(heading)); }
constexpr Heading left_of(Heading heading) { return right_of(opposite(heading)); }

/// The unit step ahead, in grid coordinates.
constexpr Cell ahead(Heading heading, bool y_up) {
  constexpr std::array<Cell, kHeadings> kDrawn{{{0, -1}, {-1, 0}, {1, 0}, {0, 1}}};
  const Cell drawn = kDrawn[static_cast<std::size_t>(heading)];
  return {drawn.x, y_up ? -drawn.y : drawn.y};
}

/// The angle of a pose in grid coordinates, from +x towards +y: a multiple of pi / 2 in (-pi, pi].
double radians_of(Heading heading, bool y_up);

/// The heading nearest to an angle in grid coordinates, which is finite.
Heading nearest_heading(double radians, bool y_up);

/// The heading that has exactly this angle, as radians_of() gives it; nothing for any other.
std::optional<Heading> exact_heading(double radians, bool y_up);

/// N, W, E, S, in capitals or not, or their numbers 0, 1, 2, 3; nothing for any other text.
std::optional<Heading> parse_heading(std::string_view text);

}  // namespace wend
