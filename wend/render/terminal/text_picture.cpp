#include "wend/render/terminal/text_picture.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "wend/geometry/line.hpp"
#include "wend/render/heatmap.hpp"
#include "wend/render/terminal/glyphs.hpp"

namespace wend {
namespace {

constexpr double kSpacing = 0.25;    // cells, between points of a line
constexpr double kMostPieces = 1e6;  // for lines that end absurdly far off the map

int pieces_of(double length) {
  const double pieces = std::ceil(std::abs(length) / kSpacing);
  return static_cast<int>(std::clamp(pieces, 1.0, kMostPieces));
}

void put_roles(const Scene& scene, Grid<Glyph>& glyphs) {
  for (const Cell cell : every_cell(glyphs)) {
    const auto role = role_of(scene, cell);
    if (!role || glyphs[cell].meaning == Meaning::obstacle) continue;
    glyphs[cell] = glyph_of(*role, scene.space.map().terrain(cell) != 1);
  }
}

/// In every cell of the path: the direction towards the next one.
void put_path(const Scene& scene, Grid<Glyph>& glyphs) {
  const auto cells = scene.path.cells();
  const RowOrder order = row_order(scene.space);
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
    if (!glyphs.contains(cells[i]) || cells[i] == cells[i + 1]) continue;
    glyphs[cells[i]] =
        arrow(order.direction(nearest_direction(cells[i], cells[i + 1])), Meaning::path);
  }
}

/// In every cell that lines or arcs lead through: the heading there.
void put_driven_path(const Scene& scene, Grid<Glyph>& glyphs) {
  for (const Arc& arc : scene.path.arcs()) {
    const int pieces = pieces_of(arc.length);
    for (int i = 0; i <= pieces; ++i) {
      const Pose pose = pose_on(arc, arc.length * i / pieces);
      if (const auto cell = cell_under(scene.space, pose.point())) {
        glyphs[*cell] = arrow(row_order(scene.space).direction(pose.heading), Meaning::path);
      }
    }
  }
}

/// Later ones over earlier ones.
void put_lines(const Scene& scene, Grid<Glyph>& glyphs) {
  for (const SceneLine& line : scene.lines) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const Line piece{line.points[i - 1], line.points[i]};
      const int pieces = pieces_of(piece.length());
      for (int k = 0; k <= pieces; ++k) {
        const auto cell = cell_under(scene.space, piece.at(static_cast<double>(k) / pieces));
        if (cell) glyphs[*cell] = glyph_of(line.role);
      }
    }
  }
}

Grid<Glyph> cell_glyphs(const Scene& scene) {
  Grid<Glyph> glyphs = glyphs_of(scene.space);
  put_roles(scene, glyphs);
  put_arrows(scene, glyphs);
  scene.path.of_steps() ? put_path(scene, glyphs) : put_driven_path(scene, glyphs);
  put_lines(scene, glyphs);
  put_marks(scene, glyphs);
  return glyphs;
}

/// A grid of texts of at most `width` characters, one a cell: `text_of(cell)`.
template <class TextOf>
std::string grid_text(const Scene& scene, TerminalColours colours, const Style& style, int width,
                      const TextOf& text_of) {
  const CellPaints paints(scene, style);
  std::string text;
  for (int n = 0; n < scene.space.height(); ++n) {
    const int y = row_order(scene.space).row(n);
    for (int x = 0; x < scene.space.width(); ++x) {
      const auto shown = text_of(Cell{x, y});
      // The blank before a number is part of its tile, so that tiles touch each other.
      const auto columns = static_cast<std::size_t>(width + (x > 0 ? 1 : 0));
      const auto heat = paints.heat({x, y});
      const std::string tile = heat ? ansi_tile(*heat, colours) : std::string();
      text.append(tile).append(columns - columns_of(shown), ' ').append(shown);
      if (!tile.empty()) text += kAnsiReset;
    }
    text += '\n';
  }
  return text;
}

/// Digits of terrain would be taken for what the layer knows.
Glyph unless_rough(Glyph glyph) {
  return glyph.meaning == Meaning::rough ? glyph_of(Meaning::free) : glyph;
}

std::string number_or_cell(double number, const FreeSpace& space, Cell cell,
                           const NumberText& text) {
  const Glyph glyph = glyph_of(space, cell);
  if (glyph.meaning == Meaning::obstacle) return std::string(glyph.text);
  if (std::isfinite(number)) return text(number);
  if (std::isinf(number) && space.passable()[cell]) return "-";
  return std::string(unless_rough(glyph).text);
}

}  // namespace

std::string text_picture(const Scene& scene, const TextStyle& style) {
  if (!scene.places.on_corners())
    return as_text(cell_glyphs(scene), row_order(scene.space), scene, style);
  return as_text(lattice_glyphs(scene, style), {}, scene, style);
}

bool fits_as_text(const Scene& scene, int columns, int rows) {
  if (scene.places.on_corners()) return lattice_fits(scene, columns, rows);
  return fits_as_text(scene.space.map(), columns, rows);
}

bool fits_as_text(const GridMap& map, int columns, int rows) {
  return map.width() <= columns && map.height() <= rows;
}

std::string text_arrows(const Scene& scene, TerminalColours colours, const Style& style) {
  assert(scene.arrows);
  Grid<Glyph> glyphs = glyphs_of(scene.space);
  for (const Cell cell : every_cell(glyphs)) glyphs[cell] = unless_rough(glyphs[cell]);
  put_arrows(scene, glyphs);
  put_marks(scene, glyphs);
  return grid_text(scene, colours, style, 1, [&](Cell cell) { return glyphs[cell].text; });
}

std::string text_numbers(const Scene& scene, TerminalColours colours, const Style& style) {
  assert(scene.heatmap);
  const Grid<double>& numbers = scene.heatmap->values;
  const NumberText text(numbers);
  return grid_text(scene, colours, style, std::max(1, text.columns()), [&](Cell cell) {
    return number_or_cell(numbers[cell], scene.space, cell, text);
  });
}

int columns_a_number(const Grid<double>& numbers) {
  return std::max(1, NumberText(numbers).columns()) + 1;
}

}  // namespace wend
