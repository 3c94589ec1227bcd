#include "wend/render/terminal/ansi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wend {
namespace {

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

}  // namespace

std::string ansi_background(const Colour& colour, TerminalColours colours) {
  switch (colours) {
    case TerminalColours::none:
      break;
    case TerminalColours::sixteen: {
      const int index = nearest_of_sixteen(colour);
      return fmt::format("\x1b[{}m", index < 8 ? 40 + index : 100 + index - 8);
    }
    case TerminalColours::palette_256:
      return fmt::format("\x1b[48;5;{}m", nearest_of_256(colour));
    case TerminalColours::true_colour: {
      const std::uint32_t rgb = rgb_of(colour);
      return fmt::format("\x1b[48;2;{};{};{}m", rgb >> 16U, (rgb >> 8U) & 255U, rgb & 255U);
    }
  }
  return {};
}

std::string ansi_tile(const Colour& colour, TerminalColours colours) {
  if (colours != TerminalColours::palette_256 && colours != TerminalColours::true_colour) return {};
  const std::uint32_t ink = rgb_of(readable_on(colour));
  // The ends of the cube are black and white.
  const std::string foreground =
      colours == TerminalColours::palette_256
          ? fmt::format("\x1b[38;5;{}m", nearest_of_256(readable_on(colour)))
          : fmt::format("\x1b[38;2;{};{};{}m", ink >> 16U, (ink >> 8U) & 255U, ink & 255U);
  return ansi_background(colour, colours) + foreground;
}

}  // namespace wend
