#include "wend/render/terminal/text_rows.hpp"

#include <bitset>

namespace wend {
namespace {

using Meanings = std::bitset<kMeanings>;

constexpr std::string_view kReset = "\x1b[0m";

/// The ANSI sequence of a meaning: colours of the terminal's own palette, so that they suit light
/// and dark ones.
constexpr std::string_view ansi_of(Meaning meaning) {
  switch (meaning) {
    case Meaning::obstacle:
    case Meaning::move:
      return "";
    case Meaning::reverse:
      return "\x1b[1m";
    case Meaning::free:
    case Meaning::unknown:
    case Meaning::corner:
    case Meaning::axis:
      return "\x1b[90m";
    case Meaning::too_close:
      return "\x1b[35m";
    case Meaning::rough:
      return "\x1b[33m";
    case Meaning::frontier:
      return "\x1b[34m";
    case Meaning::expanded:
    case Meaning::expanded_rough:
      return "\x1b[36m";
    case Meaning::current:
    case Meaning::narrowest:
    case Meaning::nearest_free:
    case Meaning::collision:
      return "\x1b[1;35m";
    case Meaning::start_component:
      return "\x1b[32m";
    case Meaning::smoothed_line:
      return "\x1b[1;32m";
    case Meaning::goal_component:
    case Meaning::yard_obstacle:
    case Meaning::planned_line:
      return "\x1b[31m";
    case Meaning::path:
    case Meaning::possible_line:
    case Meaning::ahead:
    case Meaning::pose:
    case Meaning::driven_line:
    case Meaning::robot:
      return "\x1b[1;34m";
    case Meaning::start:
      return "\x1b[1;32m";
    case Meaning::goal:
      return "\x1b[1;31m";
  }
  return "";
}

constexpr std::size_t index_of(Meaning meaning) { return static_cast<std::size_t>(meaning); }

}  // namespace

void append_row(std::string& text, std::span<const Glyph> row, const TextStyle& style) {
  std::string_view colour;
  for (const Glyph& glyph : row) {
    const std::string_view wanted = style.colours ? ansi_of(glyph.meaning) : "";
    if (wanted != colour) {
      if (!colour.empty()) text += kReset;
      text += wanted;
      colour = wanted;
    }
    text += style.ascii ? ascii_of(glyph.text) : glyph.text;
  }
  if (!colour.empty()) text += kReset;
  text += '\n';
}

void append_legend(std::string& text, const Grid<Glyph>& glyphs,
                   std::span<const TextLegendEntry> entries, const TextStyle& style) {
  constexpr std::string_view kGap = "   ";
  const auto columns = static_cast<std::size_t>(style.columns);
  Meanings seen;
  for (const Glyph& glyph : glyphs.values()) seen.set(index_of(glyph.meaning));
  std::size_t used = 0;
  for (const TextLegendEntry& entry : entries) {
    if (!seen.test(index_of(entry.meaning))) continue;
    const bool ascii = style.ascii && !entry.ascii.empty();
    const std::string_view words = ascii ? entry.ascii : entry.text;
    const std::size_t width = characters(words);
    const bool fits = used + kGap.size() + width <= columns;
    if (used > 0) text += fits ? kGap : "\n";
    used = used > 0 && fits ? used + kGap.size() + width : width;
    const std::string_view colour = style.colours ? ansi_of(entry.meaning) : "";
    text += colour;
    text += words;
    if (!colour.empty()) text += kReset;
  }
  text += '\n';
}

}  // namespace wend
