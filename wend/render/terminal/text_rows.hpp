#pragma once

// Rows of characters and their legend as text, in colours or without. All text pictures share them.

#include <span>
#include <string>
#include <string_view>

#include "wend/map/grid.hpp"
#include "wend/render/terminal/text_glyphs.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend {

struct TextLegendEntry {
  Meaning meaning;
  std::string_view text;
  std::string_view ascii{};  // where only ASCII is wanted, and the text is not
};

/// A row, with '\n' after it.
void append_row(std::string& text, std::span<const Glyph> row, const TextStyle& style);

/// The entries of what occurs, on as many lines as it takes.
void append_legend(std::string& text, const Grid<Glyph>& glyphs,
                   std::span<const TextLegendEntry> entries, const TextStyle& style);

}  // namespace wend
