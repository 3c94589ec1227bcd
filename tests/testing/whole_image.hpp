#pragma once

// Images as a whole, for tests: the library decodes them row by row.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/io/image/grey_image.hpp"
#include "wend/io/map/image_map.hpp"

namespace wend {

struct WholeImage : GreyImage {
  std::vector<std::string> notes;  // what was odd in the file, and how it was read
};

inline std::span<const std::uint16_t> row_of(const GreyImage& image, int y) {
  const auto width = static_cast<std::size_t>(image.width);
  return std::span(image.values).subspan(static_cast<std::size_t>(y) * width, width);
}

/// 1 where alpha is not full; empty if the image is opaque.
inline std::span<const unsigned char> transparent_row_of(const GreyImage& image, int y) {
  if (image.transparent.empty()) return {};
  const auto width = static_cast<std::size_t>(image.width);
  return std::span(image.transparent).subspan(static_cast<std::size_t>(y) * width, width);
}

class RowCollector final : public ImageRows {
 public:
  void begin(int width, int height, int maximum) override {
    image.width = width;
    image.height = height;
    image.maximum = maximum;
  }

  void add(std::span<const std::uint16_t> values,
           std::span<const unsigned char> transparent) override {
    image.values.insert(image.values.end(), values.begin(), values.end());
    image.transparent.insert(image.transparent.end(), transparent.begin(), transparent.end());
  }

  WholeImage image;
};

/// The image that a decoder gives row by row.
inline Expected<WholeImage, Error> whole_image(std::string_view bytes,
                                               DecodedRows (*decode)(std::string_view bytes,
                                                                     ImageRows& rows)) {
  RowCollector rows;
  auto notes = decode(bytes, rows);
  if (!notes) return Unexpected<Error>(notes.error());
  rows.image.notes = *std::move(notes);
  return std::move(rows.image);
}

inline Expected<WholeImage, Error> decode_image(std::string_view bytes) {
  return whole_image(bytes, decode_image);
}

/// The map of an image. With a frame that has y up, row 0 is the image's bottom row.
inline GridMap map_from_image(const GreyImage& image, const ImageMeaning& meaning,
                              const Frame& frame) {
  ImageMapRows rows(meaning);
  rows.begin(image.width, image.height, image.maximum);
  for (int y = 0; y < image.height; ++y) rows.add(row_of(image, y), transparent_row_of(image, y));
  return *rows.finish(frame);
}

}  // namespace wend
