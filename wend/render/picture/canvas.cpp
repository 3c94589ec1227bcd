#include "wend/render/picture/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cstring>

#include "wend/geometry/angle.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define WEND_LEAK_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define WEND_LEAK_SANITIZER
#endif

#ifdef WEND_LEAK_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

namespace wend {
namespace {

constexpr double kPointsAPixel = 0.75;  // 72 points and 96 pixels an inch

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

CairoSurface surface_of(PictureKind kind, int width, int height, std::string& bytes) {
  if (kind == PictureKind::png) return new_image(CAIRO_FORMAT_RGB24, width, height);
  if (kind == PictureKind::svg) {
    CairoSurface surface(cairo_svg_surface_create_for_stream(append_bytes, &bytes, width, height));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
    return surface;
  }
  CairoSurface surface(cairo_pdf_surface_create_for_stream(
      append_bytes, &bytes, width * kPointsAPixel, height * kPointsAPixel));
  // The same scene is to give the same bytes, at any time.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  return surface;
}

/// A byte of UTF-8 that is not the first one of its character.
bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

CairoSurface image_of(const Grid<std::uint32_t>& pixels) {
  CairoSurface image = new_image(CAIRO_FORMAT_RGB24, pixels.width(), pixels.height());
  if (cairo_surface_status(image.get()) != CAIRO_STATUS_SUCCESS) return image;
  cairo_surface_flush(image.get());
  unsigned char* row = cairo_image_surface_get_data(image.get());
  for (int y = 0; y < pixels.height(); ++y) {
    std::memcpy(row, pixels.row(y).data(), pixels.row(y).size_bytes());
    row += cairo_image_surface_get_stride(image.get());
  }
  cairo_surface_mark_dirty(image.get());
  return image;
}

Grid<std::uint32_t> pixels_of(cairo_surface_t* image) {
  if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS) return {};
  Grid<std::uint32_t> pixels(cairo_image_surface_get_width(image),
                             cairo_image_surface_get_height(image));
  copy_pixels(image, pixels);
  return pixels;
}

void copy_pixels(cairo_surface_t* image, Grid<std::uint32_t>& pixels) {
  if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS) {
    pixels = {};
    return;
  }
  cairo_surface_flush(image);
  const unsigned char* bytes = cairo_image_surface_get_data(image);
  for (int y = 0; y < pixels.height(); ++y) {
    const auto row = pixels.row(y);
    std::memcpy(row.data(), bytes, row.size_bytes());
    for (std::uint32_t& pixel : row) pixel &= 0xFFFFFFU;
    bytes += cairo_image_surface_get_stride(image);
  }
}

Expected<std::string, Error> drawn_file(PictureKind kind, int width, int height, const Colour& page,
                                        const std::function<void(cairo_t*)>& draw) {
  std::string bytes;
  const CairoSurface surface = surface_of(kind, width, height, bytes);
  const CairoContext context(cairo_create(surface.get()));
  if (kind == PictureKind::pdf) cairo_scale(context.get(), kPointsAPixel, kPointsAPixel);
  set_source(context.get(), page);
  cairo_paint(context.get());
  draw(context.get());
  cairo_status_t status = cairo_status(context.get());
  if (status == CAIRO_STATUS_SUCCESS && kind == PictureKind::png) {
    status = cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes);
  }
  cairo_surface_finish(surface.get());  // writes the rest
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) {
    return failure(Status::memory_limit, cairo_status_to_string(status));
  }
  return bytes;
}

void stroke_and_keep(cairo_t* context, double width, const Colour& colour, double opacity) {
  set_source(context, colour, opacity);
  cairo_set_line_width(context, width);
  cairo_stroke_preserve(context);
}

void stroke(cairo_t* context, double width, const Colour& colour, double opacity) {
  stroke_and_keep(context, width, colour, opacity);
  cairo_new_path(context);
}

void fill_and_keep(cairo_t* context, const Colour& colour, double opacity) {
  set_source(context, colour, opacity);
  cairo_fill_preserve(context);
}

void fill(cairo_t* context, const Colour& colour, double opacity) {
  fill_and_keep(context, colour, opacity);
  cairo_new_path(context);
}

void trace_line(cairo_t* context, Point from, Point to) {
  cairo_move_to(context, from.x, from.y);
  cairo_line_to(context, to.x, to.y);
}

void trace_circle(cairo_t* context, Point centre, double radius) {
  cairo_new_path(context);
  cairo_arc(context, centre.x, centre.y, radius, 0, 2 * kPi);
}

void select_label_font(cairo_t* context, double size) {
#ifdef WEND_LEAK_SANITIZER
  // Cairo keeps the fonts that it has found. Fontconfig's patterns point into themselves by
  // offsets, which the sanitizer does not take for pointers.
  const __lsan::ScopedDisabler disabler;
#endif
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
  cairo_get_scaled_font(context);  // looks for it now
}

double text_width(cairo_t* context, std::string_view text) {
  cairo_text_extents_t extents;
  cairo_text_extents(context, std::string(text).c_str(), &extents);
  return extents.x_advance;
}

void with_label_font(double size, const std::function<void(cairo_t*)>& measure) {
  const CairoSurface surface = new_image(CAIRO_FORMAT_RGB24, 1, 1);
  const CairoContext context(cairo_create(surface.get()));
  select_label_font(context.get(), size);
  measure(context.get());
}

void draw_text(cairo_t* context, Point baseline, std::string_view text, const Colour& colour) {
  set_source(context, colour);
  cairo_move_to(context, baseline.x, baseline.y);
  cairo_show_text(context, std::string(text).c_str());
}

std::string shortened(cairo_t* context, std::string_view text, double room) {
  if (text_width(context, text) <= room) return std::string(text);
  std::string result;
  for (std::size_t end = text.size(); end > 0; --end) {
    if (continues_character(text[end - 1])) continue;
    result = std::string(text.substr(0, end - 1)) + "…";
    if (text_width(context, result) <= room) break;
  }
  return result;
}

}  // namespace wend
