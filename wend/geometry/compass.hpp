#pragma once

// Names of directions, headings and motions: up and down, N and S, right and left as the map is
// drawn on a page. Row 0 is the bottom row of the page if the frame has y up, else its top row.
// Everything that people read or type goes through this file; all other code uses grid coordinates.
//
//   const wend::Frame frame{.y_up = true};
//   const std::string_view up = wend::name_of(wend::Direction::plus_y, frame);     // "up"
//   const std::string_view north = wend::letter_of(wend::Heading::plus_y, frame);  // "N"

#include <optional>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/segment.hpp"

namespace wend {

/// Mirrors: swaps +y and -y.
constexpr Direction mirrored(Direction direction) {
  return turned(Direction::minus_y, -static_cast<int>(direction));
}
/// The same for a heading.
constexpr Heading mirrored(Heading heading) {
  return is_along_x(heading) ? heading : opposite(heading);
}

/// Converts a direction or heading to the page, where y grows downwards, and back.
template <class T>
constexpr T on_page(T in_grid, const Frame& frame) {
  return frame.y_up ? mirrored(in_grid) : in_grid;
}

/// "down", "down_right", "right", ...
WEND_API std::string_view name_of(Direction direction, const Frame& frame);

/// A segment between two poses: "FWD", "FWD_RIGHT", "FWD_LEFT", "REV", "REV_RIGHT" or "REV_LEFT";
/// "TURN_RIGHT" or "TURN_LEFT" in place; "SIDE_RIGHT" or "SIDE_LEFT" without turning.
WEND_API std::string_view name_of(const Segment& segment, const Frame& frame);

/// "N", "W", "E" or "S"
WEND_API std::string_view letter_of(Heading heading, const Frame& frame);

/// Reads N, W, E, S in upper or lower case, or their numbers 0, 1, 2, 3; nothing for any other text.
WEND_API std::optional<Heading> parse_heading(std::string_view text, const Frame& frame);

}  // namespace wend
