#include "wend/render/picture/drawing.hpp"

#include <algorithm>

#include "wend/render/picture/canvas.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

constexpr double kLegendMargin = 8;  // of pictures for animations, left and right
constexpr int kMostPixels = 16384;   // across and down; cairo refuses more than twice that

/// A map of one cell needs none.
std::optional<ScaleBar> bar_for(const Scene& scene, const MapView& view, double room) {
  ScaleBar bar = scale_bar(scene.space.map().frame(), view.scale());
  if (bar.pixels > room / 2) return std::nullopt;
  return bar;
}

/// So that numbers over it can be read.
template <class Draw>
void draw_faintly(cairo_t* context, Draw&& draw) {
  constexpr double kOpacity = 0.4;
  cairo_push_group(context);
  draw();
  cairo_pop_group_to_source(context);
  cairo_paint_with_alpha(context, kOpacity);
}

}  // namespace

void draw_scene(cairo_t* context, const Scene& scene, const MapView& view, const Style& style,
                PictureKind kind) {
  const Style shown = style_for(scene, style);
  const SceneDrawing drawing{{context, mark_sizes(scene, view), shown}, scene, view};
  const bool numbers_cover_marks = !scene.numbers_above.empty() && shows_cell_numbers(drawing);
  draw_map(drawing, kind);
  draw_stripes(drawing);
  draw_grid_lines(drawing);
  draw_axes(drawing);
  draw_arrows(drawing, shows_cell_numbers(drawing));
  draw_motions(drawing);
  if (numbers_cover_marks) {
    draw_faintly(context, [&] {
      draw_path(drawing);
      draw_sparse_cells(drawing);
      draw_marks(drawing);
    });
    draw_cell_numbers(drawing);
    return;
  }
  draw_path(drawing);
  draw_sparse_cells(drawing);
  draw_cell_numbers(drawing);
  draw_marks(drawing);
}

Expected<std::string, Error> draw_picture(const Scene& scene, PictureKind kind,
                                          const Style& style) {
  const PictureLayout layout = picture_layout(scene.space.map(), axis_room(scene));
  const double room = layout.width - 2 * PictureLayout::kMargin;
  const Footer footer(legend_of(scene, style), bar_for(scene, layout.view, room), room);
  const int height = layout.height + (footer.lines() - 1) * Footer::kLine;
  return drawn_file(kind, layout.width, height, style.page, [&](cairo_t* context) {
    draw_scene(context, scene, layout.view, style, kind);
    footer.draw(context, layout.footer(), style);
  });
}

Grid<std::uint32_t> draw_pixels(const Scene& scene, int most_width, int most_height,
                                const Style& style, PixelLegend legend) {
  most_width = std::clamp(most_width, 1, kMostPixels);
  most_height = std::clamp(most_height, 1, kMostPixels);
  std::optional<Footer> footer;
  int footer_height = 0;
  int width = 0;
  if (legend == PixelLegend::below) {
    footer.emplace(legend_of(scene, style), std::nullopt, most_width - 2 * kLegendMargin);
    footer_height = std::min(footer->lines() * Footer::kLine, most_height - 1);
    width = most_width;
  }
  const Margins axes = axis_room(scene);
  MapView view = fitted_view(scene.space.map(), std::max(1, most_width - axes.across()),
                             std::max(1, most_height - footer_height - axes.down()), 1);
  const int across = view.width + axes.across();
  const int down = view.height + axes.down();
  width = std::max(width, across);
  const int margin = (width - across) / 2;  // whole pixels
  view.left = margin + axes.left;
  view.top = axes.top;
  const CairoSurface image = new_image(CAIRO_FORMAT_RGB24, width, down + footer_height);
  const CairoContext context(cairo_create(image.get()));
  set_source(context.get(), style.page);
  cairo_paint(context.get());
  draw_scene(context.get(), scene, view, style, PictureKind::png);
  if (footer) footer->draw(context.get(), {kLegendMargin, down + Footer::kLine / 2.0}, style);
  return pixels_of(image.get());
}

}  // namespace wend
