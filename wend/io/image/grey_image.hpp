#pragma once

// GreyImage: an image for map loaders. Row 0 is the top row; every pixel is a grey value from 0 (black)
// to `maximum` (white) and may be transparent.
//
// Colours become grey by their luma, 0.299 R + 0.587 G + 0.114 B (Rec. 601), rounded. Nav2's map
// server, through GraphicsMagick, does the same; ROS 1 took the mean of the channels.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"

namespace wend {

struct GreyImage {
  int width = 0;
  int height = 0;
  int maximum = 255;                       // the value of white, 1..65535
  std::vector<std::uint16_t> values;       // row by row
  std::vector<unsigned char> transparent;  // 1 where alpha is not full; empty: opaque everywhere
};

/// Receives an image row by row as it is decoded: like GreyImage, without its memory.
class ImageRows {
 public:
  virtual ~ImageRows() = default;

  /// Called once, before the rows. The parameters are as in GreyImage.
  virtual void begin(int width, int height, int maximum) = 0;

  /// The next row, from the top one on. `transparent` is empty in every row of an opaque image.
  virtual void add(std::span<const std::uint16_t> values,
                   std::span<const unsigned char> transparent) = 0;

  /// The same for an opaque row of bytes. False, and it has done nothing, if it takes them by add() only.
  virtual bool add_bytes(std::span<const unsigned char> /*values*/) { return false; }
};

/// Notes on unusual content of an image file and how it was read. The error is invalid_file, with the format
/// as Error::where; who knows the file adds its name.
using DecodedRows = Expected<std::vector<std::string>, Error>;

/// The luma of a colour, on the scale of its channels.
inline std::uint16_t luma(unsigned red, unsigned green, unsigned blue) {
  return static_cast<std::uint16_t>((299 * red + 587 * green + 114 * blue + 500) / 1000);
}

/// Whether the bytes begin like an image, of a format that wend reads or rejects by name.
bool looks_like_image(std::string_view bytes);

/// Decodes a PNG, PNM, BMP or JPEG file; its first bytes tell the format. An error says what is wrong, and
/// names formats that are known but not supported (TIFF, WebP, ...). On an error, `rows` may already have
/// received some rows.
DecodedRows decode_image(std::string_view bytes, ImageRows& rows);

// PNG, through libpng: grey, colour and palette, 1 to 16 bits, with and without alpha or a
// transparent colour, interlaced or not. Strict: a wrong checksum, a palette index without an entry or
// image data of the wrong length is an error.

/// Whether the bytes begin with the PNG signature.
bool looks_like_png(std::string_view bytes);

/// If the file is too short for its image size, it is rejected before anything is allocated.
DecodedRows decode_png(std::string_view bytes, ImageRows& rows);

/// An 8-bit grey PNG of an image with a maximum of 255, with an alpha channel if pixels of it are
/// transparent. The error is that of libpng.
Expected<std::string, Error> encode_png(const GreyImage& image);

// PNM: P1 and P4 (bitmaps, 1 is black), P2 and P5 (grey), P3 and P6 (colour); the first of each pair
// is text, the second binary. Samples go from 0 to the file's own maximum, 1..65535, and take two
// bytes, the high one first, if the maximum is above 255. `#` starts a comment anywhere outside binary
// samples.

/// Whether the bytes begin with P, a digit from 1 to 6, and white space.
bool looks_like_pnm(std::string_view bytes);

/// Checks that all samples exist before the image is allocated. Bytes after the last sample are
/// ignored, with a note.
DecodedRows decode_pnm(std::string_view bytes, ImageRows& rows);

/// A binary PGM (P5) of an image with a maximum of 255, without its transparency.
std::string encode_pgm(const GreyImage& image);

// BMP, through stb_image: palettes of 1, 4 and 8 bits, and 16, 24 and 32 bits, not compressed. A palette index
// without an entry is an error.

/// Whether the bytes begin with BM.
bool looks_like_bmp(std::string_view bytes);

/// If the file is too short for its image size, it is rejected before anything is allocated.
DecodedRows decode_bmp(std::string_view bytes, ImageRows& rows);

// JPEG, through libjpeg: grey and colour, also progressive. Strict: damaged data is an error. Every image gets a note,
// because JPEG does not keep grey values exactly.

/// Whether the bytes begin with the JPEG signature.
bool looks_like_jpeg(std::string_view bytes);

/// If the file is too short for its image size, it is rejected before the image is allocated.
DecodedRows decode_jpeg(std::string_view bytes, ImageRows& rows);

}  // namespace wend
