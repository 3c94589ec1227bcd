#include "wend/render/picture/map_rectangles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

constexpr std::size_t kAny = 1000000;

std::vector<MapRectangle> rectangles_of(const Scene& scene) {
  const Style style;
  return map_rectangles(CellPaints(scene, style), style.free, kAny).value();
}

TEST(MapRectangles, MergeRunsAndEqualRunsBelow) {
  const Style style;
  const Scene scene{.space = FreeSpace(map_of({
                        "##..",
                        "##.?",
                        "####",
                    }))};
  const std::vector<MapRectangle> expected{
      {style.occupied, 0, 0, 2, 2}, {style.occupied, 0, 2, 4, 1}, {style.unknown, 3, 1, 1, 1}};
  EXPECT_EQ(rectangles_of(scene), expected);
}

TEST(MapRectangles, GiveUpAboveALimit) {
  const Style style;
  const Scene scene{.space = FreeSpace(map_of({"#.#", ".#."}))};
  const CellPaints paints(scene, style);
  EXPECT_TRUE(map_rectangles(paints, style.free, 3));
  EXPECT_FALSE(map_rectangles(paints, style.free, 2));
}

RC_GTEST_PROP(MapRectangles, CoverEveryCellOnceInItsColour, ()) {
  const Style style;
  const int width = *rc::gen::inRange(1, 12);
  const int height = *rc::gen::inRange(1, 12);
  Grid<CellState> cells(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      cells[{x, y}] = *rc::gen::element(CellState::free, CellState::occupied, CellState::unknown);
    }
  }
  const Scene scene{.space = FreeSpace(GridMap(cells))};
  std::set<Cell> covered;
  for (const MapRectangle& rectangle : rectangles_of(scene)) {
    for (int y = rectangle.y; y < rectangle.y + rectangle.height; ++y) {
      for (int x = rectangle.x; x < rectangle.x + rectangle.width; ++x) {
        const Cell cell{x, y};
        RC_ASSERT(covered.insert(cell).second);
        RC_ASSERT(CellPaints(scene, style)[cell].colour == rectangle.colour);
      }
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Cell cell{x, y};
      RC_ASSERT(covered.contains(cell) == (cells[cell] != CellState::free));
    }
  }
}

}  // namespace
}  // namespace wend
