#include "wend/render/picture/scene_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "wend/render/picture/arrows.hpp"
#include "wend/render/picture/axes.hpp"
#include "wend/render/picture/cell_numbers.hpp"
#include "wend/render/picture/cell_paints.hpp"
#include "wend/render/picture/map_image.hpp"
#include "wend/render/picture/map_rectangles.hpp"
#include "wend/render/picture/marks.hpp"
#include "wend/render/picture/sparse_dots.hpp"
#include "wend/render/picture/stripes.hpp"

namespace wend {
namespace {

constexpr double kGridLinesFrom = 12;          // pixels a cell
constexpr std::size_t kMostRectangles = 4000;  // about 50 bytes each in an SVG

void draw_map_image(cairo_t* context, const CellPaints& paints, const MapView& view) {
  const CairoSurface image = image_of(map_image(paints, view.width, view.height, view.y_up));
  cairo_set_source_surface(context, image.get(), view.left, view.top);
  cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_NEAREST);
  cairo_rectangle(context, view.left, view.top, view.width, view.height);
  cairo_fill(context);
}

void draw_map_rectangles(cairo_t* context, const std::vector<MapRectangle>& rectangles,
                         const MapView& view, const Style& style) {
  set_source(context, style.free);
  cairo_rectangle(context, view.left, view.top, view.width, view.height);
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    const MapRectangle& cells = rectangles[i];
    if (i == 0 || cells.colour != rectangles[i - 1].colour) {
      cairo_fill(context);
      set_source(context, cells.colour);
    }
    const double x = cells.x;
    const double y = cells.y;
    const Point a = view.to_picture({x, y});
    const Point b = view.to_picture({x + cells.width, y + cells.height});
    cairo_rectangle(context, a.x, std::min(a.y, b.y), b.x - a.x, std::abs(b.y - a.y));
  }
  cairo_fill(context);
}

void draw_map(cairo_t* context, const Scene& scene, const MapView& view, const Style& style,
              MapForm form) {
  const CellPaints paints(scene, style);
  if (form == MapForm::rectangles_if_few) {
    if (const auto rectangles = map_rectangles(paints, style.free, kMostRectangles)) {
      return draw_map_rectangles(context, *rectangles, view, style);
    }
  }
  draw_map_image(context, paints, view);
}

/// Between all cells, or those of a car's lattice.
void draw_grid_lines(cairo_t* context, const MapView& view, int unit, const Style& style) {
  if (unit * view.scale() < kGridLinesFrom) return;
  set_source(context, style.grid_lines, 0.13);
  cairo_set_line_width(context, 1);
  for (int x = unit; x < view.columns; x += unit) {
    const double at = std::floor(view.to_picture({static_cast<double>(x), 0}).x) + 0.5;
    cairo_move_to(context, at, view.top);
    cairo_line_to(context, at, view.top + view.height);
  }
  for (int y = unit; y < view.rows; y += unit) {
    const double at = std::floor(view.to_picture({0, static_cast<double>(y)}).y) + 0.5;
    cairo_move_to(context, view.left, at);
    cairo_line_to(context, view.left + view.width, at);
  }
  cairo_stroke(context);
}

void draw_frame(cairo_t* context, const MapView& view, const Style& style) {
  set_source(context, style.ink);
  cairo_set_line_width(context, 1);
  cairo_rectangle(context, view.left - 0.5, view.top - 0.5, view.width + 1, view.height + 1);
  cairo_stroke(context);
}

}  // namespace

void draw_scene(cairo_t* context, const Scene& scene, const MapView& view, const Style& style,
                MapForm form) {
  const Style shown = style_for(scene, style);
  const int unit = scene.unit.value_or(1);
  const MarkSizes sizes = mark_sizes(scene, view);
  draw_map(context, scene, view, shown, form);
  draw_stripes(context, CellPaints(scene, shown), view);
  draw_grid_lines(context, view, unit, shown);
  draw_frame(context, view, shown);
  draw_axes(context, scene, view, shown);
  if (scene.arrows) {
    draw_arrows(context, *scene.arrows, view, shows_cell_numbers(context, scene, view), shown);
  }
  draw_path(context, scene, view, sizes, shown);
  draw_sparse_cells(context, scene, view, shown);
  draw_cell_numbers(context, scene, view, shown);
  draw_marks(context, scene, view, sizes, shown);
}

}  // namespace wend
