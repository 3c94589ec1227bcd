#include "wend/geometry/compass.hpp"

namespace wend {
namespace {

// Indexed by the direction on a page.
constexpr std::array<std::string_view, kDirections> kDirectionNames{
    "down", "down_right", "right", "up_right", "up", "up_left", "left", "down_left"};
constexpr std::array<std::string_view, kHeadings> kLetters{"N", "W", "E", "S"};
constexpr std::array<std::string_view, kCarMoves> kMoveNames{"FWD", "FWD_RIGHT", "FWD_LEFT",
                                                             "REV", "REV_RIGHT", "REV_LEFT"};

}  // namespace

std::string_view name_of(Direction direction, const Frame& frame) {
  return kDirectionNames[static_cast<std::size_t>(on_page(direction, frame))];
}

std::string_view name_of(CarMove move, const Frame& frame) {
  return kMoveNames[static_cast<std::size_t>(on_page(move, frame))];
}

std::optional<CarMove> parse_car_move(std::string_view name) {
  for (std::size_t i = 0; i < kMoveNames.size(); ++i) {
    if (kMoveNames[i] == name) return static_cast<CarMove>(i);
  }
  return std::nullopt;
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
