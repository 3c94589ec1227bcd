#include "wend/render/text_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "wend/render/text_glyphs.hpp"

namespace wend {
namespace {

constexpr int kMostDecimals = 2;
// Sums of square roots are whole numbers only up to rounding.
constexpr double kRounding = 1e-9;

bool whole(double number) {
  return std::abs(number - std::round(number)) <= kRounding * std::max(1.0, std::abs(number));
}

/// The least number of decimals that shows all numbers exactly, or kMostDecimals.
int decimals_of(const Grid<double>& numbers) {
  int decimals = 0;
  double factor = 1;
  for (const double number : numbers.values()) {
    while (decimals < kMostDecimals && std::isfinite(number) && !whole(number * factor)) {
      ++decimals;
      factor *= 10;
    }
  }
  return decimals;
}

std::string text_of(double number, int decimals) {
  if (std::isnan(number)) return ".";
  if (std::isinf(number)) return number > 0 ? "∞" : "-∞";
  return fmt::format("{:.{}f}", number, decimals);
}

/// Characters, not bytes, of UTF-8.
std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

std::size_t column_width(const Grid<double>& numbers, int decimals) {
  std::size_t widest = 1;
  for (const double number : numbers.values()) {
    widest = std::max(widest, characters(text_of(number, decimals)));
  }
  return widest;
}

}  // namespace

std::string text_arrows(const Scene& scene, const Grid<std::optional<Direction>>& arrows) {
  assert(arrows.width() == scene.space.width() && arrows.height() == scene.space.height());
  Grid<Glyph> glyphs = glyphs_of(scene.space);
  for (int y = 0; y < glyphs.height(); ++y) {
    for (int x = 0; x < glyphs.width(); ++x) {
      if (const auto direction = arrows[{x, y}]) glyphs[{x, y}] = arrow(*direction);
    }
  }
  put_marks(scene, glyphs);

  std::string text;
  for (int n = 0; n < glyphs.height(); ++n) {
    std::string_view gap;
    for (const Glyph& glyph : glyphs.row(drawn_row(scene.space, n))) {
      text += gap;
      text += glyph.text;
      gap = " ";
    }
    text += '\n';
  }
  return text;
}

std::string text_numbers(const FreeSpace& space, const Grid<double>& numbers) {
  assert(numbers.width() == space.width() && numbers.height() == space.height());
  const int decimals = decimals_of(numbers);
  const std::size_t width = column_width(numbers, decimals);
  std::string text;
  for (int n = 0; n < numbers.height(); ++n) {
    const int y = drawn_row(space, n);
    for (int x = 0; x < numbers.width(); ++x) {
      const std::string number =
          space.passable({x, y}) ? text_of(numbers[{x, y}], decimals) : std::string("-");
      text.append(width + (x > 0 ? 1 : 0) - characters(number), ' ');
      text += number;
    }
    text += '\n';
  }
  return text;
}

int columns_a_number(const Grid<double>& numbers) {
  return static_cast<int>(column_width(numbers, decimals_of(numbers))) + 1;
}

}  // namespace wend
