#pragma once

// Makes PNG files byte by byte, without libpng, so that tests can also make odd and broken ones.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace wend::png_file {

inline std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFFU);
  return bytes;
}

inline std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1 ^ 0xEDB88320U : crc >> 1;
  }
  return ~crc;
}

inline std::uint32_t adler32(std::string_view bytes) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char byte : bytes) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

inline std::string chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
         big_endian(crc32(type + data));
}

enum Colour : char { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgb_alpha = 6 };

inline std::string header(std::uint32_t width, std::uint32_t height, char depth, char colour,
                          char interlace = 0) {
  return chunk("IHDR",
               big_endian(width) + big_endian(height) + depth + colour + '\0' + '\0' + interlace);
}

/// Image data, stored without compression; at most 65535 bytes.
inline std::string image_data(const std::string& scanlines) {
  const auto size = static_cast<std::uint16_t>(scanlines.size());
  const auto low_first = [](std::uint16_t value) {
    return std::string{static_cast<char>(value & 0xFFU), static_cast<char>(value >> 8)};
  };
  return chunk("IDAT", "\x78\x01\x01" + low_first(size) +
                           low_first(static_cast<std::uint16_t>(~size)) + scanlines +
                           big_endian(adler32(scanlines)));
}

/// The scanlines of rows that lie one after the other in `bytes`: each after the filter type 0.
inline std::string scanlines(std::string_view bytes, std::size_t row_bytes) {
  std::string lines;
  for (std::size_t at = 0; at < bytes.size(); at += row_bytes) {
    lines += '\0';
    lines += bytes.substr(at, row_bytes);
  }
  return lines;
}

/// The same for an interlaced image with one byte a pixel.
inline std::string interlaced_scanlines(std::string_view bytes, std::size_t width) {
  struct Pass {
    std::size_t x, y, step_x, step_y;
  };
  constexpr std::array<Pass, 7> kAdam7 = {{{0, 0, 8, 8},
                                           {4, 0, 8, 8},
                                           {0, 4, 4, 8},
                                           {2, 0, 4, 4},
                                           {0, 2, 2, 4},
                                           {1, 0, 2, 2},
                                           {0, 1, 1, 2}}};
  std::string lines;
  for (const Pass& pass : kAdam7) {
    if (pass.x >= width) continue;
    for (std::size_t y = pass.y; y < bytes.size() / width; y += pass.step_y) {
      lines += '\0';
      for (std::size_t x = pass.x; x < width; x += pass.step_x) lines += bytes[y * width + x];
    }
  }
  return lines;
}

/// A file with these chunks.
inline std::string file(const std::string& chunks) {
  return "\x89PNG\r\n\x1A\n" + chunks + chunk("IEND", "");
}

}  // namespace wend::png_file
