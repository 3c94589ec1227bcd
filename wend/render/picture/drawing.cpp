#include "wend/render/picture/drawing.hpp"

#include <algorithm>
#include <cstring>

#include "wend/render/picture/canvas.hpp"
#include "wend/render/picture/footer.hpp"
#include "wend/render/picture/picture_layout.hpp"
#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

constexpr double kLongestBar = 200;
constexpr double kLegendMargin = 8;  // of pictures for animations, left and right
constexpr int kMostPixels = 16384;   // across and down; cairo refuses more than twice that

/// A map of one cell needs none.
std::optional<ScaleBar> bar_for(const Scene& scene, const MapView& view, double room) {
  ScaleBar bar = scale_bar(scene.space.map().frame(), view.scale(), kLongestBar);
  if (bar.pixels > room / 2) return std::nullopt;
  return bar;
}

Grid<std::uint32_t> pixels_of(cairo_surface_t* image) {
  if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS) return {};
  cairo_surface_flush(image);
  Grid<std::uint32_t> pixels(cairo_image_surface_get_width(image),
                             cairo_image_surface_get_height(image));
  const unsigned char* bytes = cairo_image_surface_get_data(image);
  for (int y = 0; y < pixels.height(); ++y) {
    const auto row = pixels.row(y);
    std::memcpy(row.data(), bytes, row.size_bytes());
    for (std::uint32_t& pixel : row) pixel &= 0xFFFFFFU;
    bytes += cairo_image_surface_get_stride(image);
  }
  return pixels;
}

}  // namespace

Expected<std::string, RenderError> draw_picture(const Scene& scene, PictureKind kind,
                                                const Style& style) {
  PictureLayout layout = picture_layout(scene.space.map(), axis_room(scene));
  const double room = layout.width - 2 * PictureLayout::kMargin;
  const Footer footer(legend_of(scene, style), bar_for(scene, layout.view, room), room);
  layout.add_footer_lines(footer.lines() - 1);
  return drawn_file(kind, layout.width, layout.height, [&](cairo_t* context) {
    set_source(context, style.page);
    cairo_paint(context);
    draw_scene(context, scene, layout.view, style, map_form(kind));
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
  const AxisRoom axes = axis_room(scene);
  MapView view = fitted_view(scene.space.map(), std::max(1, most_width - axes.across()),
                             std::max(1, most_height - footer_height - axes.down()), 1);
  const int across = view.width + axes.across();
  const int down = view.height + axes.down();
  width = std::max(width, across);
  const int margin = (width - across) / 2;  // whole pixels
  view.left = margin + axes.left;
  view.top = axes.top;
  const CairoSurface image(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, down + footer_height));
  const CairoContext context(cairo_create(image.get()));
  set_source(context.get(), style.page);
  cairo_paint(context.get());
  draw_scene(context.get(), scene, view, style, MapForm::image);
  if (footer) {
    footer->draw(context.get(), {kLegendMargin, down + Footer::kLine / 2.0}, style);
  }
  return pixels_of(image.get());
}

}  // namespace wend
