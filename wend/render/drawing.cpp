#include "wend/render/drawing.hpp"

#include <cairo-svg.h>

#include <string>
#include <vector>

#include "wend/render/cairo_objects.hpp"
#include "wend/render/cell_paints.hpp"
#include "wend/render/footer.hpp"
#include "wend/render/map_image.hpp"
#include "wend/render/map_rectangles.hpp"
#include "wend/render/marks.hpp"
#include "wend/render/picture_layout.hpp"

namespace wend {
namespace {

constexpr double kGridLinesFrom = 12;          // pixels a cell
constexpr std::size_t kMostRectangles = 4000;  // about 50 bytes each in an SVG

enum class MapForm { image, rectangles_if_few };

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

void draw_grid_lines(cairo_t* context, const MapView& view, const Style& style) {
  if (view.scale() < kGridLinesFrom) return;
  set_source(context, style.grid_lines, 0.13);
  cairo_set_line_width(context, 1);
  for (int x = 1; x < view.columns; ++x) {
    const double at = view.left + x * view.scale() + 0.5;
    cairo_move_to(context, at, view.top);
    cairo_line_to(context, at, view.top + view.height);
  }
  for (int y = 1; y < view.rows; ++y) {
    const double at = view.top + y * view.scale() + 0.5;
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

void draw_picture(cairo_t* context, const Scene& scene, const PictureLayout& layout,
                  const Style& style, MapForm form) {
  set_source(context, style.page);
  cairo_paint(context);
  draw_map(context, scene, layout.view, style, form);
  draw_grid_lines(context, layout.view, style);
  draw_frame(context, layout.view, style);
  draw_marks(context, scene, layout.view, mark_sizes(layout.view.scale()), style);
  draw_footer(context, scene, layout, style);
}

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

Expected<std::string, RenderError> finished(cairo_status_t status, std::string bytes) {
  if (status != CAIRO_STATUS_SUCCESS) {
    return Unexpected<RenderError>({cairo_status_to_string(status)});
  }
  return bytes;
}

}  // namespace

Expected<std::string, RenderError> draw_png(const Scene& scene, const Style& style) {
  const PictureLayout layout = picture_layout(scene.space.map());
  const CairoSurface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, layout.width, layout.height));
  const CairoContext context(cairo_create(surface.get()));
  draw_picture(context.get(), scene, layout, style, MapForm::image);
  cairo_status_t status = cairo_status(context.get());
  std::string bytes;
  if (status == CAIRO_STATUS_SUCCESS) {
    status = cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes);
  }
  return finished(status, std::move(bytes));
}

Expected<std::string, RenderError> draw_svg(const Scene& scene, const Style& style) {
  const PictureLayout layout = picture_layout(scene.space.map());
  std::string bytes;
  const CairoSurface surface(
      cairo_svg_surface_create_for_stream(append_bytes, &bytes, layout.width, layout.height));
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  const CairoContext context(cairo_create(surface.get()));
  draw_picture(context.get(), scene, layout, style, MapForm::rectangles_if_few);
  cairo_status_t status = cairo_status(context.get());
  cairo_surface_finish(surface.get());  // writes the rest
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface.get());
  return finished(status, std::move(bytes));
}

}  // namespace wend
