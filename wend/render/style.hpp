#pragma once

// Style: the colours of a picture. The default is light and safe for colour-blind eyes: marks are
// Okabe and Ito's blue, green and vermilion, and each differs from the others in shape as well.

#include <cstdint>

namespace wend {

/// Red, green and blue from 0 to 1.
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;

  friend constexpr bool operator==(const Colour&, const Colour&) = default;
};

/// From 0xRRGGBB.
constexpr Colour colour_from(std::uint32_t rgb) {
  return {static_cast<double>((rgb >> 16U) & 255U) / 255,
          static_cast<double>((rgb >> 8U) & 255U) / 255, static_cast<double>(rgb & 255U) / 255};
}

/// From `a` (share 0) to `b` (share 1).
constexpr Colour mixed(const Colour& a, const Colour& b, double share) {
  return {a.red + share * (b.red - a.red), a.green + share * (b.green - a.green),
          a.blue + share * (b.blue - a.blue)};
}

struct Style {
  // Cells.
  Colour free = colour_from(0xFFFFFF);
  Colour occupied = colour_from(0x2B2D33);
  Colour unknown = colour_from(0xC6C9CE);
  Colour too_close = colour_from(0xE4DDEF);       // free, but nearer to an obstacle than the radius
  Colour slightly_rough = colour_from(0xFBF3D3);  // a terrain multiplier just above 1
  Colour very_rough = colour_from(0xAD7F3C);      // a large one
  Colour visited = colour_from(0xBFE0F4);
  Colour grid_lines = colour_from(0x2B2D33);

  // Marks.
  Colour path = colour_from(0x0072B2);
  Colour start = colour_from(0x009E73);
  Colour goal = colour_from(0xD55E00);
  Colour halo = colour_from(0xFFFFFF);  // around marks, for contrast

  // Around the map.
  Colour page = colour_from(0xFFFFFF);
  Colour ink = colour_from(0x3C4047);
};

}  // namespace wend
