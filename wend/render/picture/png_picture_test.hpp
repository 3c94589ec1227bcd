#pragma once

// Pictures as tests read them back.

#include <cairo/cairo.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace wend {

/// A PNG as cairo reads it back.
class Picture {
 public:
  explicit Picture(std::string_view png)
      : surface_(cairo_image_surface_create_from_png_stream(take_bytes, &png),
                 cairo_surface_destroy) {}

  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }

  std::uint32_t pixel(double x, double y) const {
    const unsigned char* bytes =
        cairo_image_surface_get_data(surface_.get()) +
        cairo_image_surface_get_stride(surface_.get()) * static_cast<std::ptrdiff_t>(y) +
        4 * static_cast<std::ptrdiff_t>(x);
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, bytes, sizeof pixel);
    return pixel & 0xFFFFFFU;
  }

 private:
  static cairo_status_t take_bytes(void* rest, unsigned char* bytes, unsigned count) {
    auto& png = *static_cast<std::string_view*>(rest);
    if (png.size() < count) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(bytes, png.data(), count);
    png.remove_prefix(count);
    return CAIRO_STATUS_SUCCESS;
  }

  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
};

/// Every element is closed, in order. (No comments, no '>' in attributes.)
inline bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n\t/", 1));
    if (tag.starts_with('?')) continue;
    if (tag.starts_with('/')) {
      if (open.empty() || "/" + open.back() != name) return false;
      open.pop_back();
    } else if (!tag.ends_with('/')) {
      open.push_back(name);
    }
  }
  return open.empty();
}

inline bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

}  // namespace wend
