#include "wend/render/map_rectangles.hpp"

#include <algorithm>
#include <tuple>

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

bool continues(const MapRectangle& run, const MapRectangle& above) {
  return run.x == above.x && run.width == above.width && run.colour == above.colour;
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
  std::vector<MapRectangle> done;
  std::vector<MapRectangle> open;  // those that reach down to the row before, from left to right
  for (int y = 0; y < paints.height(); ++y) {
    std::vector<MapRectangle> runs = runs_of_row(paints, y, background);
    auto above = open.begin();
    for (MapRectangle& run : runs) {
      while (above != open.end() && above->x < run.x) done.push_back(*above++);
      if (above == open.end() || !continues(run, *above)) continue;
      run.y = above->y;
      run.height = above->height + 1;
      ++above;
    }
    done.insert(done.end(), above, open.end());
    open = std::move(runs);
    if (done.size() + open.size() > most) return std::nullopt;
  }
  done.insert(done.end(), open.begin(), open.end());
  std::sort(done.begin(), done.end(), by_colour);
  return done;
}

}  // namespace wend
