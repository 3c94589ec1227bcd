// BMP, through stb_image. It reads bytes beyond the end of a file as 0 and trusts what a header says, so the header
// is checked here first.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstdlib>
#include <memory>
#include <optional>

#include "wend/io/image/grey_image.hpp"
#include "wend/map/grid_map.hpp"

#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace wend {
namespace {

constexpr std::string_view kBmpSignature = "BM";
constexpr std::size_t kFileHeader = 14;
constexpr std::size_t kLeastInfoHeader = 40;
constexpr std::size_t kPaletteEntry = 4;
constexpr std::array<std::size_t, 6> kBits = {1, 4, 8, 16, 24, 32};  // of a pixel

Unexpected<Error> bmp_failure(const std::string& what) {
  return failure(Status::invalid_file, "BMP: " + what, "BMP");
}

/// A number of `count` bytes, the low one first.
std::uint32_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

/// What the header says, in range.
struct BmpLayout {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t bits = 0;     // of a pixel
  std::size_t begin = 0;    // of the pixels in the file
  std::size_t palette = 0;  // entries

  std::size_t used_row_bytes() const { return (width * bits + 7) / 8; }
  std::size_t row_bytes() const { return (used_row_bytes() + 3) / 4 * 4; }
  std::size_t end() const { return begin + row_bytes() * (height - 1) + used_row_bytes(); }
};

Expected<BmpLayout, Error> bmp_layout(std::string_view bytes) {
  if (bytes.size() < kFileHeader + kLeastInfoHeader) return bmp_failure("the file is truncated");
  const std::size_t header = little_endian(bytes, 14, 4);
  if (header < kLeastInfoHeader) return bmp_failure("headers of OS/2 are not supported");
  const auto width = static_cast<std::int32_t>(little_endian(bytes, 18, 4));
  const auto height = static_cast<std::int32_t>(little_endian(bytes, 22, 4));
  if (width < 1 || height == 0 || height == INT_MIN) {
    return bmp_failure(fmt::format("{} x {} pixels", width, height));
  }
  BmpLayout layout{.width = static_cast<std::size_t>(width),
                   .height = static_cast<std::size_t>(std::abs(height)),
                   .bits = little_endian(bytes, 28, 2),
                   .begin = little_endian(bytes, 10, 4)};
  if (std::ranges::find(kBits, layout.bits) == kBits.end()) {
    return bmp_failure(fmt::format("{} bits a pixel", layout.bits));
  }
  if (layout.width > GridMap::kMaxCells / layout.height || layout.end() > bytes.size()) {
    return bmp_failure(
        fmt::format("{} x {} pixels are too large or truncated, the file has {} bytes",
                    layout.width, layout.height, bytes.size()));
  }
  if (layout.bits > 8) return layout;
  if (layout.begin < kFileHeader + header + kPaletteEntry) return bmp_failure("without a palette");
  layout.palette = (layout.begin - kFileHeader - header) / kPaletteEntry;
  return layout;
}

/// The first palette index without an entry, if there is one.
std::optional<unsigned> wrong_index(std::string_view bytes, const BmpLayout& layout) {
  if (layout.bits > 8 || layout.palette >= std::size_t{1} << layout.bits) return std::nullopt;
  const unsigned mask = (1U << layout.bits) - 1;
  for (std::size_t y = 0; y < layout.height; ++y) {
    const std::string_view row = bytes.substr(layout.begin + y * layout.row_bytes());
    for (std::size_t x = 0; x < layout.width; ++x) {
      const std::size_t bit = x * layout.bits;
      const auto byte = static_cast<unsigned char>(row[bit / 8]);
      const unsigned index = byte >> (8 - layout.bits - bit % 8) & mask;
      if (index >= layout.palette) return index;
    }
  }
  return std::nullopt;
}

/// Hands over the pixels that stb_image made: red, green and blue, and alpha if there are four channels.
void add_pixels(std::span<const unsigned char> pixels, const BmpLayout& layout, bool alpha,
                ImageRows& rows) {
  const std::size_t channels = alpha ? 4 : 3;
  std::vector<std::uint16_t> values(layout.width);
  std::vector<unsigned char> transparent(alpha ? layout.width : 0);
  rows.begin(static_cast<int>(layout.width), static_cast<int>(layout.height), 255);
  for (std::size_t y = 0; y < layout.height; ++y) {
    for (std::size_t x = 0; x < layout.width; ++x) {
      const auto pixel = pixels.subspan((y * layout.width + x) * channels, channels);
      values[x] = luma(pixel[0], pixel[1], pixel[2]);
      if (alpha) transparent[x] = pixel[3] == 255 ? 0 : 1;
    }
    rows.add(values, transparent);
  }
}

}  // namespace

bool looks_like_bmp(std::string_view bytes) { return bytes.starts_with(kBmpSignature); }

DecodedRows decode_bmp(std::string_view bytes, ImageRows& rows) {
  const auto layout = bmp_layout(bytes);
  if (!layout) return Unexpected<Error>(layout.error());
  if (const auto index = wrong_index(bytes, *layout)) {
    return bmp_failure(
        fmt::format("palette index {} out of range ({} entries)", *index, layout->palette));
  }
  if (bytes.size() > INT_MAX) return bmp_failure("the file is larger than 2 GiB");
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &width, &height, &channels, 0),
      stbi_image_free);
  if (!pixels) {
    return bmp_failure(fmt::format("{} (uncompressed BMP expected)", stbi_failure_reason()));
  }
  const auto count = layout->width * layout->height * static_cast<std::size_t>(channels);
  add_pixels({pixels.get(), count}, *layout, channels == 4, rows);
  return std::vector<std::string>();
}

}  // namespace wend
