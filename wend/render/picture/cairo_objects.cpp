#include "wend/render/picture/cairo_objects.hpp"

#include <cstring>

namespace wend {

CairoSurface image_of(const Grid<std::uint32_t>& pixels) {
  CairoSurface image(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width(), pixels.height()));
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

}  // namespace wend
