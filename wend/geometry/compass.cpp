#include "wend/geometry/compass.hpp"

#include <cmath>

namespace wend {
namespace {

// Indexed by the direction on a page.
constexpr std::array<std::string_view, kDirections> kDirectionNames{
    "down", "down_right", "right", "up_right", "up", "up_left", "left", "down_left"};
constexpr std::array<std::string_view, kHeadings> kLetters{"N", "W", "E", "S"};

}  // namespace

std::string_view name_of(Direction direction, const Frame& frame) {
  return kDirectionNames[static_cast<std::size_t>(on_page(direction, frame))];
}

std::string_view name_of(const Segment& segment, const Frame& frame) {
  constexpr double kStraight = 1e-6;  // radians
  // Headings grow to the left where y is drawn upwards.
  const auto is_left = [&](double angle) { return (angle > 0) == frame.y_up; };
  const bool turns = std::abs(segment.turn) > kStraight;
  if (segment.length == 0) return is_left(segment.turn) ? "TURN_LEFT" : "TURN_RIGHT";
  const bool ahead = segment.length > 0;
  if (!turns && std::abs(segment.course) > kStraight) {
    return is_left(ahead ? segment.course : -segment.course) ? "SIDE_LEFT" : "SIDE_RIGHT";
  }
  if (!turns) return ahead ? "FWD" : "REV";
  const bool centre_is_left = is_left(ahead ? segment.turn : -segment.turn);
  if (ahead) return centre_is_left ? "FWD_LEFT" : "FWD_RIGHT";
  return centre_is_left ? "REV_LEFT" : "REV_RIGHT";
}

std::string_view letter_of(Heading heading, const Frame& frame) {
  return kLetters[static_cast<std::size_t>(on_page(heading, frame))];
}

std::optional<Heading> parse_heading(std::string_view text, const Frame& frame) {
  if (text.size() != 1) return std::nullopt;
  for (const Heading heading : kAllHeadings) {
    const char capital = kLetters[static_cast<std::size_t>(heading)].front();
    const char small = static_cast<char>(capital - 'A' + 'a');
    const char number = static_cast<char>('0' + static_cast<int>(heading));
    if (text.front() == capital || text.front() == small || text.front() == number) {
      return on_page(heading, frame);
    }
  }
  return std::nullopt;
}

}  // namespace wend
