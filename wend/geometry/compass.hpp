#pragma once

// Names of directions, headings and car moves: up and down, N and S, right and left are those of
// the map on a page. Row 0 is the page's bottom row where the frame has y up, its top
// row elsewhere. Everything that people read or type goes through here; all else is in grid
// coordinates.
//
//   const wend::Frame frame{.y_up = true};
//   const std::string_view up = wend::name_of(wend::Direction::plus_y, frame);     // "up"
//   const std::string_view north = wend::letter_of(wend::Heading::plus_y, frame);  // "N"

#include <optional>
#include <string_view>

#include "wend/geometry/car_move.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/geometry/frame.hpp"

namespace wend {

/// The same where +y is -y.
constexpr Direction mirrored(Direction direction) {
  return turned(Direction::minus_y, -static_cast<int>(direction));
}
constexpr Heading mirrored(Heading heading) {
  return is_along_x(heading) ? heading : opposite(heading);
}
constexpr CarMove mirrored(CarMove move) {
  return static_cast<CarMove>(static_cast<int>(move) + side_of(move));
}

/// What a direction, heading or move is on a page, where y grows downwards; and back.
template <class T>
constexpr T on_page(T in_grid, const Frame& frame) {
  return frame.y_up ? mirrored(in_grid) : in_grid;
}

/// "down", "down_right", "right", ...
std::string_view name_of(Direction direction, const Frame& frame);

/// "FWD", "FWD_RIGHT", "FWD_LEFT", "REV", "REV_RIGHT" or "REV_LEFT".
std::string_view name_of(CarMove move, const Frame& frame);

/// The move of that name on a page: on_page() makes it one of the grid. Nothing for any other text.
std::optional<CarMove> parse_car_move(std::string_view name);

/// "N", "W", "E" or "S"
std::string_view letter_of(Heading heading, const Frame& frame);

/// N, W, E, S, in capitals or not, or their numbers 0, 1, 2, 3; nothing for any other text.
std::optional<Heading> parse_heading(std::string_view text, const Frame& frame);

}  // namespace wend
