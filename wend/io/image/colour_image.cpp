#include "wend/io/image/colour_image.hpp"

#include <fmt/format.h>
#include <png.h>

#include <cstddef>
#include <string>

#include "wend/map/grid_map.hpp"

namespace wend {
namespace {

/// Deflate expands one byte to at most 1032, and a pixel takes a bit or more.
constexpr std::size_t kMostPixelsOfByte = std::size_t{8} * 1032;

Unexpected<Error> no_colours(const std::string& what) {
  return failure(Status::invalid_file, "PNG: " + what, "PNG");
}

}  // namespace

Expected<ColourImage, Error> decode_colours(std::string_view bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
    return no_colours(image.message);
  }
  const std::size_t count = std::size_t{image.width} * image.height;
  if (count > GridMap::kMaxCells || count / kMostPixelsOfByte > bytes.size()) {
    png_image_free(&image);
    return no_colours(
        fmt::format("{} x {} pixels are too large or truncated", image.width, image.height));
  }
  image.format = PNG_FORMAT_RGBA;
  ColourImage colours{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  colours.pixels.resize(count);
  if (png_image_finish_read(&image, nullptr, colours.pixels.data(), 0, nullptr) == 0) {
    png_image_free(&image);
    return no_colours(image.message);
  }
  return colours;
}

}  // namespace wend
