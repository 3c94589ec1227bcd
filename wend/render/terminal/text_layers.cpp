#include "wend/render/terminal/text_layers.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "wend/render/number_text.hpp"
#include "wend/render/picture/cell_paints.hpp"
#include "wend/render/terminal/ansi.hpp"
#include "wend/render/terminal/text_glyphs.hpp"

namespace wend {
namespace {

/// What every cell shows, as text of at most `width` characters.
class TextGrid {
 public:
  TextGrid(const Scene& scene, TerminalColours colours, const Style& style)
      : scene_(scene), colours_(colours), paints_(scene, style) {}

  /// `text_of(cell)` gives the text of a cell.
  template <class TextOf>
  std::string text(int width, const TextOf& text_of) const {
    std::string text;
    for (int n = 0; n < scene_.space.height(); ++n) {
      const int y = drawn_row(scene_.space, n);
      for (int x = 0; x < scene_.space.width(); ++x) {
        // The blank before a number is part of its tile, so that tiles touch each other.
        append({x, y}, text_of(Cell{x, y}), width + (x > 0 ? 1 : 0), text);
      }
      text += '\n';
    }
    return text;
  }

 private:
  void append(Cell cell, std::string_view shown, int columns, std::string& text) const {
    const auto heat = paints_.heat(cell);
    const std::string tile = heat ? ansi_tile(*heat, colours_) : std::string();
    text += tile;
    text.append(static_cast<std::size_t>(columns) - characters(shown), ' ');
    text += shown;
    if (!tile.empty()) text += kAnsiReset;
  }

  const Scene& scene_;
  TerminalColours colours_;
  CellPaints paints_;
};

/// Digits of terrain would be taken for what the layer knows.
Glyph unless_rough(Glyph glyph) {
  return glyph.meaning == Meaning::rough ? Glyph{".", Meaning::free} : glyph;
}

std::string shown(double number, const FreeSpace& space, Cell cell, const NumberText& text) {
  const Glyph glyph = glyph_of(space, cell);
  if (glyph.meaning == Meaning::obstacle) return std::string(glyph.text);
  if (std::isfinite(number)) return text(number);
  if (std::isinf(number) && space.passable()[cell]) return "-";
  return std::string(unless_rough(glyph).text);
}

}  // namespace

std::string text_arrows(const Scene& scene, TerminalColours colours, const Style& style) {
  assert(scene.arrows);
  Grid<Glyph> glyphs = glyphs_of(scene.space);
  for (int y = 0; y < glyphs.height(); ++y) {
    for (Glyph& glyph : glyphs.row(y)) glyph = unless_rough(glyph);
  }
  put_arrows(scene, glyphs);
  put_marks(scene, glyphs);
  return TextGrid(scene, colours, style).text(1, [&](Cell cell) { return glyphs[cell].text; });
}

std::string text_numbers(const Scene& scene, TerminalColours colours, const Style& style) {
  assert(scene.heatmap);
  const Grid<double>& numbers = scene.heatmap->values;
  const NumberText text(numbers);
  return TextGrid(scene, colours, style).text(std::max(1, text.columns()), [&](Cell cell) {
    return shown(numbers[cell], scene.space, cell, text);
  });
}

int columns_a_number(const Grid<double>& numbers) {
  return std::max(1, NumberText(numbers).columns()) + 1;
}

}  // namespace wend
