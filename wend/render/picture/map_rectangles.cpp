#include "wend/render/picture/map_rectangles.hpp"

#include <algorithm>
#include <tuple>

#include "wend/map/joined_rows.hpp"

namespace wend {
namespace {

/// The runs of equal colour in row y, as rectangles one cell high, from left to right.
std::vector<MapRectangle> runs_of_row(const CellPaints& paints, int y, const Colour& background) {
  std::vector<MapRectangle> runs;
  Colour last = background;
  for (int x = 0; x < paints.width(); ++x) {
    const Colour colour = paints[{x, y}].colour;
    if (colour != background) {
      if (colour == last) {
        ++runs.back().width;
      } else {
        runs.push_back({colour, x, y, 1, 1});
      }
    }
    last = colour;
  }
  return runs;
}

bool by_colour(const MapRectangle& a, const MapRectangle& b) {
  const auto key = [](const MapRectangle& rectangle) {
    const Colour& colour = rectangle.colour;
    return std::tuple(colour.red, colour.green, colour.blue, rectangle.y, rectangle.x);
  };
  return key(a) < key(b);
}

}  // namespace

std::optional<std::vector<MapRectangle>> map_rectangles(const CellPaints& paints,
                                                        const Colour& background,
                                                        std::size_t most) {
  auto rectangles = joined_rows<MapRectangle>(
      paints.height(), most, [&](int y) { return runs_of_row(paints, y, background); },
      [](const MapRectangle& a, const MapRectangle& b) { return a.colour == b.colour; });
  if (rectangles) std::sort(rectangles->begin(), rectangles->end(), by_colour);
  return rectangles;
}

}  // namespace wend
