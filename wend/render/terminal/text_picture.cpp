#include "wend/render/terminal/text_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/render/terminal/lattice_picture.hpp"
#include "wend/render/terminal/text_rows.hpp"

namespace wend {
namespace {

// In the order of the legend, most interesting first.
constexpr std::array<TextLegendEntry, 23> kLegend{{
    {Meaning::start, "S start"},
    {Meaning::goal, "G goal"},
    {Meaning::path, "→ path", "> path"},
    {Meaning::planned_line, "○ planned", "o planned"},
    {Meaning::smoothed_line, "● smoothed", "% smoothed"},
    {Meaning::driven_line, "◆ driven", "& driven"},
    {Meaning::possible_line, "◇ possible path", "- possible path"},
    {Meaning::robot, "R robot"},
    {Meaning::collision, "✗ collision", "X collision"},
    {Meaning::narrowest, "! narrowest"},
    {Meaning::nearest_free, "N nearest free cell"},
    {Meaning::current, "@ being expanded"},
    {Meaning::frontier, "+ frontier"},
    {Meaning::expanded, "* expanded"},
    {Meaning::expanded_rough, "% expanded, rough"},
    {Meaning::start_component, "s start's region"},
    {Meaning::goal_component, "g goal's region"},
    {Meaning::move, "→ way to move", "> way to move"},
    {Meaning::obstacle, "# obstacle"},
    {Meaning::too_close, ": too close for the robot"},
    {Meaning::unknown, "? unknown"},
    {Meaning::rough, "~ 3-9 rough"},
    {Meaning::free, ". free"},
}};

/// The legend's entries, with the labels that the scene's lines have of their own.
class SceneLegend {
 public:
  explicit SceneLegend(const Scene& scene) : entries_(kLegend.begin(), kLegend.end()) {
    for (const SceneLine& line : scene.lines) {
      if (line.label.empty()) continue;
      const Glyph glyph = glyph_of(line.role);
      const auto entry = std::ranges::find(entries_, glyph.meaning, &TextLegendEntry::meaning);
      entry->text = keep(glyph.text, line.label);
      entry->ascii = keep(ascii_of(glyph.text), line.label);
    }
  }

  std::span<const TextLegendEntry> entries() const { return entries_; }

 private:
  std::string_view keep(std::string_view character, const std::string& label) {
    return words_.emplace_back(std::string(character) + " " + label);
  }

  std::vector<TextLegendEntry> entries_;
  std::deque<std::string> words_;  // what entries of lines show
};

void put_roles(const Scene& scene, Grid<Glyph>& glyphs) {
  for (int y = 0; y < glyphs.height(); ++y) {
    for (int x = 0; x < glyphs.width(); ++x) {
      if (glyphs[{x, y}].meaning == Meaning::obstacle) continue;
      const auto role = role_of(scene, {x, y});
      if (!role) continue;
      const bool rough = scene.space.map().terrain({x, y}) != 1;
      glyphs[{x, y}] = rough ? glyph_on_rough_ground(*role) : glyph_of(*role);
    }
  }
}

/// In every cell that poses or waypoints lead through: the heading there.
void put_driven_path(const Scene& scene, Grid<Glyph>& glyphs) {
  constexpr double kSpacing = 0.25;  // cells
  const bool y_up = scene.space.map().frame().y_up;
  if (!scene.path.cells().empty()) return;
  for (const Arc& arc : scene.path.arcs()) {
    const auto pieces = std::max(1, static_cast<int>(std::ceil(std::abs(arc.length) / kSpacing)));
    for (int i = 0; i <= pieces; ++i) {
      const Pose pose = pose_on(arc, arc.length * i / pieces);
      if (const auto cell = cell_under(scene.space, pose.point())) {
        glyphs[*cell] = arrow(nearest_direction(pose.heading, y_up), Meaning::path);
      }
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

}  // namespace

std::string text_picture(const Scene& scene, const TextStyle& style) {
  if (scene.unit) return lattice_picture(scene, style);
  Grid<Glyph> glyphs = glyphs_of(scene.space);
  put_roles(scene, glyphs);
  put_arrows(scene, glyphs);
  put_path(scene, glyphs);
  put_driven_path(scene, glyphs);
  put_lines(scene, glyphs);
  put_marks(scene, glyphs);

  std::string text;
  for (int n = 0; n < glyphs.height(); ++n) {
    append_row(text, std::as_const(glyphs).row(drawn_row(scene.space, n)), style);
  }
  if (style.legend) append_legend(text, glyphs, SceneLegend(scene).entries(), style);
  return text;
}

bool fits_as_text(const Scene& scene, int columns, int rows) {
  if (scene.unit) return lattice_fits(scene, columns, rows);
  return fits_as_text(scene.space.map(), columns, rows);
}

bool fits_as_text(const GridMap& map, int columns, int rows) {
  return map.width() <= columns && map.height() <= rows;
}

}  // namespace wend
