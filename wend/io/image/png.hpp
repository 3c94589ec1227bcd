#pragma once

// PNG images, through libpng: grey, colour and palette, 1 to 16 bits, with and without alpha or a
// transparent colour, interlaced or not. Strict: a checksum that is wrong, a palette index without
// an entry or image data of the wrong length is an error.

#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/io/image/grey_image.hpp"

namespace wend {

/// Whether the bytes begin with the PNG signature.
bool looks_like_png(std::string_view bytes);

/// Sizes that the file is too short for are refused before anything is allocated.
Expected<GreyImage, std::string> decode_png(std::string_view bytes);

/// The same row by row.
DecodedRows decode_png(std::string_view bytes, ImageRows& rows);

/// An 8-bit grey PNG of an image with a maximum of 255, with an alpha channel if pixels of it are
/// transparent.
Expected<std::string, std::string> encode_png(const GreyImage& image);

}  // namespace wend
