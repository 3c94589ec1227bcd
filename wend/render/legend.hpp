#pragma once

// The legend of a scene: what its marks and colours mean, only of those that occur. Pictures draw
// it below the map, terminals print it.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/render/heatmap.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// What an entry shows, in the order of the legend: most interesting first.
enum class Swatch : unsigned char {
  heat,
  start,
  goal,
  narrowest,
  nearest_free,
  collision,
  path,
  driven,   // ahead, with an arrow
  reverse,  // driven in reverse
  // Lines, in the order of LineRole.
  planned_line,
  smoothed_line,
  driven_line,
  possible_line,
  arrow,
  role,
  cell
};

struct LegendItem {
  Swatch swatch;
  Colour colour;  // of all but heat
  std::string label;
  HeatRange range{};                 // of heat
  char character = ' ';              // in ASCII pictures; heat has digits
  std::optional<Stripes> stripes{};  // where there is room for them; else the colour

  /// Of a line.
  std::optional<LineRole> line() const {
    if (swatch < Swatch::planned_line || swatch > Swatch::possible_line) return std::nullopt;
    return static_cast<LineRole>(static_cast<int>(swatch) - static_cast<int>(Swatch::planned_line));
  }

  friend bool operator==(const LegendItem&, const LegendItem&) = default;
};

/// In the order of their swatches. O(cells).
std::vector<LegendItem> legend_of(const Scene& scene, const Style& style);

/// What several scenes show, each entry once, in the same order. O(cells of all).
std::vector<LegendItem> legend_of(std::span<const Scene> scenes, const Style& style);

}  // namespace wend
