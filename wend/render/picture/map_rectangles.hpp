#pragma once

// The cells of a map as few rectangles, for vector formats: cells of one colour in a row become
// one, and so do equal ones in rows that follow each other.

#include <cstddef>
#include <optional>
#include <vector>

#include "wend/render/picture/cell_paints.hpp"

namespace wend {

struct MapRectangle {
  Colour colour;
  int x = 0;  // cells
  int y = 0;
  int width = 0;
  int height = 0;

  friend constexpr bool operator==(const MapRectangle&, const MapRectangle&) = default;
};

/// Rectangles of all cells that are not of the colour `background`, those of one colour together;
/// nothing if there are more than `most`. O(cells).
std::optional<std::vector<MapRectangle>> map_rectangles(const CellPaints& paints,
                                                        const Colour& background, std::size_t most);

}  // namespace wend
