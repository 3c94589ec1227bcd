#include "wend/render/terminal/terminal.hpp"

#include <chafa.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace wend {
namespace {

std::string_view variable(const char* const* environment, std::string_view name) {
  for (; *environment != nullptr; ++environment) {
    const std::string_view entry = *environment;
    if (entry.size() > name.size() && entry.starts_with(name) && entry[name.size()] == '=') {
      return entry.substr(name.size() + 1);
    }
  }
  return {};
}

// What terminals make of their sixteen colours differs; these are xterm's.
constexpr std::array<std::uint32_t, 16> kSixteen{
    0x000000, 0xCD0000, 0x00CD00, 0xCDCD00, 0x0000EE, 0xCD00CD, 0x00CDCD, 0xE5E5E5,
    0x7F7F7F, 0xFF0000, 0x00FF00, 0xFFFF00, 0x5C5CFF, 0xFF00FF, 0x00FFFF, 0xFFFFFF};

double distance(const Colour& a, const Colour& b) {
  return std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue);
}

int nearest_of_sixteen(const Colour& colour) {
  const auto nearest = std::ranges::min_element(
      kSixteen, {}, [&](std::uint32_t rgb) { return distance(colour, colour_from(rgb)); });
  return static_cast<int>(nearest - kSixteen.begin());
}

constexpr std::array<int, 6> kCubeLevels{0, 95, 135, 175, 215, 255};

Colour bytes(int red, int green, int blue) { return {red / 255.0, green / 255.0, blue / 255.0}; }

/// The level of the 6 x 6 x 6 cube that is nearest to a part of a colour.
int cube_level(double part) {
  const auto nearest = std::ranges::min_element(
      kCubeLevels, {}, [&](int level) { return std::abs(level - 255 * part); });
  return static_cast<int>(nearest - kCubeLevels.begin());
}

/// Among the cube and the 24 greys; the first sixteen are the user's own.
int nearest_of_256(const Colour& colour) {
  const auto level = [](int index) { return kCubeLevels[static_cast<std::size_t>(index)]; };
  const int red = cube_level(colour.red);
  const int green = cube_level(colour.green);
  const int blue = cube_level(colour.blue);
  const double cube = distance(colour, bytes(level(red), level(green), level(blue)));
  const double mean = 255 * (colour.red + colour.green + colour.blue) / 3;
  const int grey = std::clamp(static_cast<int>(std::lround((mean - 8) / 10)), 0, 23);
  const int value = 8 + 10 * grey;
  if (distance(colour, bytes(value, value, value)) < cube) return 232 + grey;
  return 16 + 36 * red + 6 * green + blue;
}

/// `ground` is 38 for the foreground and 48 for the background; empty with sixteen colours or fewer.
std::string sequence(int ground, const Colour& colour, TerminalColours colours) {
  if (colours == TerminalColours::palette_256) {
    return fmt::format("\x1b[{};5;{}m", ground, nearest_of_256(colour));
  }
  if (colours != TerminalColours::true_colour) return {};
  const std::uint32_t rgb = rgb_of(colour);
  return fmt::format("\x1b[{};2;{};{};{}m", ground, rgb >> 16U, (rgb >> 8U) & 255U, rgb & 255U);
}

}  // namespace

Terminal detect_terminal(const char* const* environment) {
  const std::string_view term = variable(environment, "TERM");
  if (term.empty() || term == "dumb") return {.unicode = false};
  if (!variable(environment, "NO_COLOR").empty()) return {};
  // Chafa copies what it reads, but its type is that of C's environ.
  const std::unique_ptr<ChafaTermInfo, decltype(&chafa_term_info_unref)> info(
      chafa_term_db_detect(chafa_term_db_get_default(), const_cast<gchar**>(environment)),
      chafa_term_info_unref);
  const auto has = [&](ChafaTermSeq sequence) {
    return chafa_term_info_have_seq(info.get(), sequence) != FALSE;
  };
  Terminal terminal{TerminalGraphics::half_blocks, TerminalColours::sixteen};
  if (has(CHAFA_TERM_SEQ_BEGIN_SIXELS)) terminal.graphics = TerminalGraphics::sixel;
  if (has(CHAFA_TERM_SEQ_BEGIN_KITTY_IMMEDIATE_IMAGE_V1)) {
    terminal.graphics = TerminalGraphics::kitty;
  }
  if (has(CHAFA_TERM_SEQ_SET_COLOR_FGBG_256)) terminal.colours = TerminalColours::palette_256;
  if (has(CHAFA_TERM_SEQ_SET_COLOR_FGBG_DIRECT)) terminal.colours = TerminalColours::true_colour;
  return terminal;
}

std::size_t columns_of(std::string_view text) {
  std::size_t columns = 0;
  bool in_sequence = false;
  for (const char byte : text) {
    if (byte == '\x1b') in_sequence = true;
    const bool continues = (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
    if (!in_sequence && !continues) ++columns;
    if (byte == 'm') in_sequence = false;
  }
  return columns;
}

std::string in_lines(const std::vector<std::string>& entries, int columns) {
  constexpr std::string_view kGap = "   ";
  std::string text;
  std::size_t used = 0;
  for (const std::string& entry : entries) {
    const std::size_t width = columns_of(entry);
    const bool fits = used + kGap.size() + width <= static_cast<std::size_t>(columns);
    if (used > 0) text += fits ? kGap : "\n";
    used = used > 0 && fits ? used + kGap.size() + width : width;
    text += entry;
  }
  return text;
}

std::string ansi_background(const Colour& colour, TerminalColours colours) {
  if (colours != TerminalColours::sixteen) return sequence(48, colour, colours);
  const int index = nearest_of_sixteen(colour);
  return fmt::format("\x1b[{}m", index < 8 ? 40 + index : 100 + index - 8);
}

std::string ansi_tile(const Colour& colour, TerminalColours colours) {
  // The ends of the cube are black and white.
  return sequence(48, colour, colours) + sequence(38, readable_on(colour), colours);
}

}  // namespace wend
