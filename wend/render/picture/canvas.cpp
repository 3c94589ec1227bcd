#include "wend/render/picture/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <utility>

namespace wend {
namespace {

constexpr double kPointsAPixel = 0.75;  // 72 points and 96 pixels an inch

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

CairoSurface surface_of(PictureKind kind, int width, int height, std::string& bytes) {
  switch (kind) {
    case PictureKind::png:
      break;
    case PictureKind::svg: {
      CairoSurface surface(
          cairo_svg_surface_create_for_stream(append_bytes, &bytes, width, height));
      cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
      return surface;
    }
    case PictureKind::pdf: {
      CairoSurface surface(cairo_pdf_surface_create_for_stream(
          append_bytes, &bytes, width * kPointsAPixel, height * kPointsAPixel));
      // The same scene is to give the same bytes, at any time.
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
      return surface;
    }
  }
  return CairoSurface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
}

}  // namespace

Expected<std::string, RenderError> drawn_file(PictureKind kind, int width, int height,
                                              const std::function<void(cairo_t*)>& draw) {
  std::string bytes;
  const CairoSurface surface = surface_of(kind, width, height, bytes);
  const CairoContext context(cairo_create(surface.get()));
  if (kind == PictureKind::pdf) cairo_scale(context.get(), kPointsAPixel, kPointsAPixel);
  draw(context.get());
  cairo_status_t status = cairo_status(context.get());
  if (status == CAIRO_STATUS_SUCCESS && kind == PictureKind::png) {
    status = cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes);
  }
  cairo_surface_finish(surface.get());  // writes the rest
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) {
    return Unexpected<RenderError>({cairo_status_to_string(status)});
  }
  return bytes;
}

}  // namespace wend
