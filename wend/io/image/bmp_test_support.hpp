#pragma once

// Makes BMP files byte by byte, so that tests can also make odd and broken ones.

#include <cstddef>
#include <cstdint>
#include <string>

namespace wend::bmp_file {

inline std::string little_endian_bytes(std::uint32_t value, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
  return bytes;
}

/// A file with the header that most programs write, of 40 bytes.
inline std::string file(int width, int height, int bits, const std::string& palette,
                        const std::string& pixels) {
  const auto u32 = [](auto value) {
    return little_endian_bytes(static_cast<std::uint32_t>(value), 4);
  };
  const auto u16 = [](int value) {
    return little_endian_bytes(static_cast<std::uint32_t>(value), 2);
  };
  const std::size_t begin = 54 + palette.size();
  return "BM" + u32(begin + pixels.size()) + u32(0) + u32(begin) + u32(40) + u32(width) +
         u32(height) + u16(1) + u16(bits) + u32(0) + u32(pixels.size()) + u32(2835) + u32(2835) +
         u32(palette.size() / 4) + u32(0) + palette + pixels;
}

}  // namespace wend::bmp_file
