#pragma once

// Style: the colours of a picture. Three come with wend: light, dark, and one for print that
// survives a black-and-white printer. All are safe for colour-blind eyes: what may lie side by side
// differs in lightness or along blue and yellow, and marks differ in shape as well (a disc, a
// target, a ring with ticks). The light one's marks are Okabe and Ito's blue, green and vermilion.
//
// One thing has one colour in all pictures of a style, and the one that is nearest to it among a
// terminal's; docs/colours.md lists them, and a test compares that list with this file.
//
//   const auto svg = wend::draw_svg(scene, wend::style_of(wend::StyleName::dark));
//
// CellPaints gives the colour of every cell of a scene in a style.

#include <array>
#include <cstdint>
#include <optional>

#include "wend/base/choice.hpp"
#include "wend/render/scene.hpp"

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

/// As 0xRRGGBB, each part rounded.
std::uint32_t rgb_of(const Colour& colour);

/// From `a` (share 0) to `b` (share 1).
constexpr Colour mixed(const Colour& a, const Colour& b, double share) {
  return {a.red + share * (b.red - a.red), a.green + share * (b.green - a.green),
          a.blue + share * (b.blue - a.blue)};
}

/// Black or white: what is better to read on that colour.
Colour readable_on(const Colour& colour);

/// Lines differ in width and dashes too: see path_drawing.cpp. The light style's.
struct LineColours {
  Colour planned = colour_from(0xBE1A2B);
  Colour smoothed = colour_from(0x2FB563);
  Colour driven = colour_from(0x1546C7);
};

/// The light style, unless changed.
struct Style {
  // Cells.
  Colour free = colour_from(0xFFFFFF);
  Colour occupied = colour_from(0x2B2D33);
  Colour yard_occupied = colour_from(0xC8232C);  // the same in a yard that a car drives over
  Colour unknown = colour_from(0xC6C9CE);
  Colour too_close = colour_from(0xE4DDEF);       // free, but nearer to an obstacle than the radius
  Colour slightly_rough = colour_from(0xFFF3B0);  // a terrain multiplier just above 1
  Colour very_rough = colour_from(0xD99A00);      // a large one
  bool stripes_all_rough = false;  // or only where it lies under a role; for want of colours
  Colour grid_lines = colour_from(0x2B2D33);

  // Cells with a role.
  Colour expanded = colour_from(0x9BD0F2);
  Colour frontier = colour_from(0x4F8FE0);
  Colour current = colour_from(0xD03A86);
  Colour start_component = colour_from(0x6AD2B2);
  Colour goal_component = colour_from(0xFAC79B);

  // Heat, from the least value to the greatest: evenly spaced, each further from the page.
  std::array<Colour, 5> heat_colours{colour_from(0xFFF3BF), colour_from(0xFCCE8C),
                                     colour_from(0xF2A07C), colour_from(0xDB7486),
                                     colour_from(0xB0559A)};

  LineColours lines{};

  // Marks.
  Colour arrows = colour_from(0x3C4047);
  Colour path = colour_from(0x0072B2);
  Colour reverse = colour_from(0x1B1E24);  // the path where a car drives it in reverse: dashed
  Colour start = colour_from(0x009E73);
  Colour goal = colour_from(0xD55E00);
  Colour narrowest = colour_from(0x7D0552);  // and where the robot collides
  Colour halo = colour_from(0xFFFFFF);       // around marks, for contrast

  // Around the map.
  Colour page = colour_from(0xFFFFFF);
  Colour ink = colour_from(0x3C4047);

  /// The colour of a cell whose ground is rough by a multiplier above 1.
  Colour rough(double multiplier) const;

  /// The colour of the stripes by which such ground shows under a role.
  Colour stripe(double multiplier) const;

  /// The colour of a cell with a role on rough ground: between both, for where there is no room
  /// for stripes.
  Colour of(CellRole role, double multiplier) const;

  /// The colour of a value that lies that share of the way (0 to 1) from the least to the greatest.
  Colour heat(double share) const;

  Colour of(CellRole role) const;
  Colour of(LineRole role) const;
};

enum class StyleName { light, dark, print };

constexpr std::array<Choice<StyleName>, 3> choice_names(StyleName) {
  return {{{"light", StyleName::light}, {"dark", StyleName::dark}, {"print", StyleName::print}}};
}

Style style_of(StyleName name);

/// How rough terrain looks: from 0 for a multiplier of 1 to 1 for one of 10 or more, by its
/// logarithm.
double roughness(double multiplier);

/// The style as a scene is drawn in it: obstacles are red where a car drives, except beside heat,
/// which has red of its own.
Style style_for(const Scene& scene, const Style& style);

/// The colour of a cell, and how much it counts where many cells share a pixel.
struct Paint {
  Colour colour;
  double weight = 1;
};

/// A cell of two colours.
struct Stripes {
  Colour base;
  Colour stripe;

  friend constexpr bool operator==(const Stripes&, const Stripes&) = default;
};

class CellPaints {
 public:
  /// Both must outlive this; the scene's layers are as large as its map.
  CellPaints(const Scene& scene, const Style& style);

  int width() const { return scene_.space.width(); }
  int height() const { return scene_.space.height(); }

  Paint operator[](Cell cell) const;

  bool is_obstacle(Cell cell) const {
    return scene_.space.map().state(cell) == CellState::occupied;
  }

  /// How rough ground shows where it needs stripes: under a role, or everywhere in a style that has
  /// greys alone.
  std::optional<Stripes> stripes(Cell cell) const;

  /// The colour of a cell's value in the heatmap, where it has a finite one and is not an obstacle; none where the
  /// scene's motions have the colours.
  std::optional<Colour> heat(Cell cell) const;

 private:
  const Scene& scene_;
  const Style& style_;
  std::optional<HeatRange> range_;  // of the heatmap, where it has a finite value
};

/// Is that ground drawn as rough, by itself or under a role?
bool is_rough(const Scene& scene, Cell cell);

}  // namespace wend
