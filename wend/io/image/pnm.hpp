#pragma once

// PNM images: P1 and P4 (bitmaps, 1 is black), P2 and P5 (grey), P3 and P6 (colour); the first of
// each pair is text, the second binary. Samples go from 0 to the file's own maximum, 1..65535, and
// take two bytes, the high one first, where that is above 255. `#` starts a comment anywhere
// outside binary samples.

#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/io/image/grey_image.hpp"

namespace wend {

/// P, a digit from 1 to 6, white space.
bool looks_like_pnm(std::string_view bytes);

/// Whether all samples are there is known before the image is allocated. Bytes after the last
/// sample are ignored, with a note.
Expected<GreyImage, std::string> decode_pnm(std::string_view bytes);

/// The same row by row.
DecodedRows decode_pnm(std::string_view bytes, ImageRows& rows);

/// A binary PGM (P5) of an image with a maximum of 255, its transparency left out.
std::string encode_pgm(const GreyImage& image);

}  // namespace wend
