#include <algorithm>
#include <string_view>
#include <vector>

#include "wend/render/legend.hpp"
#include "wend/render/number_text.hpp"
#include "wend/render/terminal/ansi.hpp"
#include "wend/render/terminal/terminal_picture.hpp"
#include "wend/render/terminal/text_glyphs.hpp"

namespace wend {
namespace {

constexpr int kBar = 20;  // characters
constexpr std::string_view kEntryGap = "   ";

/// A piece of the legend, and how many columns it takes.
struct Piece {
  std::string text;
  int columns = 0;
};

int columns_of(std::string_view text) { return static_cast<int>(characters(text)); }

Piece plain_piece(const LegendItem& item) {
  const std::string text = item.swatch == Swatch::heat
                               ? "0-9 " + item.label + ", " + short_number(item.range.least) +
                                     " to " + short_number(item.range.greatest)
                               : std::string(1, item.character) + " " + item.label;
  return {text, columns_of(text)};
}

/// The title, the least value, a bar, and the greatest.
Piece heat_piece(const LegendItem& item, TerminalColours colours, const Style& style) {
  const std::string before = item.label + "  " + short_number(item.range.least) + " ";
  const std::string after = ' ' + short_number(item.range.greatest);
  std::string bar;
  for (int i = 0; i < kBar; ++i) {
    bar += ansi_background(style.heat(static_cast<double>(i) / (kBar - 1)), colours) + " ";
  }
  return {before + bar + kAnsiReset + after, columns_of(before) + kBar + columns_of(after)};
}

Piece coloured_piece(const LegendItem& item, TerminalColours colours, const Style& style) {
  if (item.swatch == Swatch::heat) return heat_piece(item, colours, style);
  constexpr std::string_view kSwatch = "  ";
  return {
      ansi_background(item.colour, colours) + std::string(kSwatch) + kAnsiReset + " " + item.label,
      columns_of(kSwatch) + 1 + columns_of(item.label)};
}

std::string lines_of(const std::vector<Piece>& pieces, int columns) {
  std::string text;
  int used = 0;
  for (const Piece& piece : pieces) {
    const int gap = used == 0 ? 0 : columns_of(kEntryGap);
    if (used > 0 && used + gap + piece.columns > columns) {
      text += '\n';
      used = 0;
    } else if (used > 0) {
      text += kEntryGap;
      used += gap;
    }
    text += piece.text;
    used += piece.columns;
  }
  if (!pieces.empty()) text += '\n';
  return text;
}

}  // namespace

std::string terminal_legend(const Scene& scene, int columns, const Terminal& terminal,
                            const Style& style) {
  const bool plain =
      terminal.graphics == TerminalGraphics::ascii || terminal.colours == TerminalColours::none;
  const Style shown = suited(scene, style, terminal.colours);
  std::vector<Piece> pieces;
  for (const LegendItem& item : legend_of(scene, shown)) {
    const bool drawn =
        plain ? item.swatch == Swatch::heat || item.character != ' '
              : item.swatch != Swatch::arrow || terminal.graphics != TerminalGraphics::half_blocks;
    if (!drawn) continue;
    pieces.push_back(plain ? plain_piece(item) : coloured_piece(item, terminal.colours, shown));
  }
  return lines_of(pieces, columns);
}

}  // namespace wend
