#pragma once

// The colours of a PNG, for masks whose zones are painted.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"

namespace wend {

/// Red, green, blue and alpha, 0 to 255.
using Colour = std::array<std::uint8_t, 4>;

struct ColourImage {
  int width = 0;
  int height = 0;
  std::vector<Colour> pixels;  // row by row, from the top one on
};

/// Decodes a PNG of at most GridMap::kMaxCells pixels. The error is invalid_file, with "PNG" as Error::where.
Expected<ColourImage, Error> decode_colours(std::string_view bytes);

}  // namespace wend
