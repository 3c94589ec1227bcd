#include "wend/render/text_picture.hpp"

#include <array>
#include <bitset>
#include <string_view>

#include "wend/render/text_glyphs.hpp"

namespace wend {
namespace {

using Meanings = std::bitset<kMeanings>;

struct LegendEntry {
  Meaning meaning;
  std::string_view text;
};

// In the order of the legend, most interesting first.
constexpr std::array<LegendEntry, kMeanings> kLegend{{
    {Meaning::start, "S start"},
    {Meaning::goal, "G goal"},
    {Meaning::path, "→ path"},
    {Meaning::narrowest, "! narrowest"},
    {Meaning::current, "@ being expanded"},
    {Meaning::frontier, "+ frontier"},
    {Meaning::expanded, "* expanded"},
    {Meaning::start_region, "s start's region"},
    {Meaning::goal_region, "g goal's region"},
    {Meaning::move, "→ way to move"},
    {Meaning::obstacle, "# obstacle"},
    {Meaning::too_close, ": too close for the robot"},
    {Meaning::unknown, "? unknown"},
    {Meaning::rough, "~ 3-9 rough"},
    {Meaning::free, ". free"},
}};

constexpr std::size_t index_of(Meaning meaning) { return static_cast<std::size_t>(meaning); }

/// The ANSI sequence of a meaning: colours of the terminal's own palette, so that they suit light
/// and dark ones.
constexpr std::string_view ansi_of(Meaning meaning) {
  switch (meaning) {
    case Meaning::obstacle:
      return "";
    case Meaning::free:
    case Meaning::unknown:
      return "\x1b[90m";
    case Meaning::too_close:
      return "\x1b[35m";
    case Meaning::rough:
      return "\x1b[33m";
    case Meaning::expanded:
      return "\x1b[36m";
    case Meaning::frontier:
      return "\x1b[33m";
    case Meaning::current:
    case Meaning::narrowest:
      return "\x1b[1;35m";
    case Meaning::start_region:
      return "\x1b[32m";
    case Meaning::goal_region:
      return "\x1b[31m";
    case Meaning::move:
      return "\x1b[34m";
    case Meaning::path:
      return "\x1b[1;34m";
    case Meaning::start:
      return "\x1b[1;32m";
    case Meaning::goal:
      return "\x1b[1;31m";
  }
  return "";
}

constexpr std::string_view kReset = "\x1b[0m";

void put_roles(const Scene& scene, Grid<Glyph>& glyphs) {
  for (int y = 0; y < glyphs.height(); ++y) {
    for (int x = 0; x < glyphs.width(); ++x) {
      if (glyphs[{x, y}].meaning == Meaning::obstacle) continue;
      if (const auto role = role_of(scene, {x, y})) glyphs[{x, y}] = glyph_of(*role);
    }
  }
}

void put_path(const Scene& scene, Grid<Glyph>& glyphs) {
  const auto cells = scene.path.cells();
  const bool y_up = scene.space.map().frame().y_up;
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
    if (!glyphs.contains(cells[i]) || cells[i] == cells[i + 1]) continue;
    glyphs[cells[i]] = arrow(nearest_direction(cells[i], cells[i + 1], y_up), Meaning::path);
  }
}

void append_row(std::string& text, std::span<const Glyph> row, bool colours) {
  std::string_view colour;
  for (const Glyph& glyph : row) {
    const std::string_view wanted = colours ? ansi_of(glyph.meaning) : "";
    if (wanted != colour) {
      if (!colour.empty()) text += kReset;
      text += wanted;
      colour = wanted;
    }
    text += glyph.text;
  }
  if (!colour.empty()) text += kReset;
  text += '\n';
}

void append_legend(std::string& text, const Grid<Glyph>& glyphs, const TextStyle& style) {
  constexpr std::string_view kGap = "   ";
  const auto columns = static_cast<std::size_t>(style.columns);
  Meanings seen;
  for (const Glyph& glyph : glyphs.values()) seen.set(index_of(glyph.meaning));
  std::size_t used = 0;
  for (const LegendEntry& entry : kLegend) {
    if (!seen.test(index_of(entry.meaning))) continue;
    const std::size_t width = characters(entry.text);
    const bool fits = used + kGap.size() + width <= columns;
    if (used > 0) text += fits ? kGap : "\n";
    used = used > 0 && fits ? used + kGap.size() + width : width;
    const std::string_view colour = style.colours ? ansi_of(entry.meaning) : "";
    text += colour;
    text += entry.text;
    if (!colour.empty()) text += kReset;
  }
  text += '\n';
}

}  // namespace

std::string text_picture(const Scene& scene, const TextStyle& style) {
  Grid<Glyph> glyphs = glyphs_of(scene.space);
  put_roles(scene, glyphs);
  put_arrows(scene, glyphs);
  put_path(scene, glyphs);
  put_marks(scene, glyphs);

  std::string text;
  for (int n = 0; n < glyphs.height(); ++n) {
    append_row(text, std::as_const(glyphs).row(drawn_row(scene.space, n)), style.colours);
  }
  if (style.legend) append_legend(text, glyphs, style);
  return text;
}

bool fits_as_text(const GridMap& map, int columns, int rows) {
  return map.width() <= columns && map.height() <= rows;
}

}  // namespace wend
