#include "wend/render/picture/map_image.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

constexpr Style kStyle{.free = colour_from(0xFFFFFF),
                       .occupied = colour_from(0x000000),
                       .unknown = colour_from(0x808080)};

std::uint32_t pixel_of(const Grid<std::uint32_t>& image, int x, int y) { return image[{x, y}]; }

TEST(MapImage, EnlargesCellsToCrispSquares) {
  const Scene scene{.space = FreeSpace(map_of({"#.", ".?"}))};
  const auto image = map_image(CellPaints(scene, kStyle), 6, 6, false);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x) {
      const std::uint32_t expected =
          x < 3 && y < 3 ? 0x000000U : (x >= 3 && y >= 3 ? 0x808080U : 0xFFFFFFU);
      EXPECT_EQ(pixel_of(image, x, y), expected) << x << ", " << y;
    }
  }
}

TEST(MapImage, TurnsMapsWithYUpOver) {
  const Scene scene{.space = FreeSpace(map_of({"#..", "...", "..?"}, {.y_up = true}))};
  const auto image = map_image(CellPaints(scene, kStyle), 3, 3, true);
  EXPECT_EQ(pixel_of(image, 0, 0), 0x000000U);
  EXPECT_EQ(pixel_of(image, 2, 2), 0x808080U);
  EXPECT_EQ(pixel_of(image, 0, 2), 0xFFFFFFU);
}

TEST(MapImage, KeepsThinWallsVisibleWhenItShrinks) {
  Grid<CellState> cells(64, 64);
  for (int y = 0; y < 64; ++y) cells[{21, y}] = CellState::occupied;
  const Scene scene{.space = FreeSpace(GridMap(cells))};
  const auto image = map_image(CellPaints(scene, kStyle), 8, 8, false);
  for (int y = 0; y < 8; ++y) {
    EXPECT_LT(pixel_of(image, 2, y) & 0xFFU, 0xC0U);  // cells 16 to 23
    EXPECT_EQ(pixel_of(image, 1, y), 0xFFFFFFU);
    EXPECT_EQ(pixel_of(image, 3, y), 0xFFFFFFU);
  }
}

TEST(MapImage, MixesTheCellsUnderAPixelByTheAreaTheyShare) {
  const Scene scene{.space = FreeSpace(map_of({".?."}))};
  const auto image = map_image(CellPaints(scene, kStyle), 2, 1, false);
  // Each pixel is two thirds of a free cell and one third of the unknown one.
  EXPECT_EQ(pixel_of(image, 0, 0), 0xD5D5D5U);
  EXPECT_EQ(pixel_of(image, 1, 0), 0xD5D5D5U);
}

TEST(MapImage, PaintsTooCloseExpandedAndRoughCells) {
  Scene scene{.space = FreeSpace(map_of({"#..2.9"}), {.robot_radius = 1})};
  BitGrid expanded(6, 1);
  expanded.set({4, 0}, true);
  scene.marked = {{CellRole::expanded, expanded}};
  const auto image = map_image(CellPaints(scene, {}), 6, 1, false);
  EXPECT_EQ(pixel_of(image, 1, 0), 0xE4DDEFU);
  EXPECT_EQ(pixel_of(image, 2, 0), 0xFFFFFFU);
  EXPECT_EQ(pixel_of(image, 4, 0), 0x9BD0F2U);
  EXPECT_GT(pixel_of(image, 3, 0), pixel_of(image, 5, 0)) << "rougher is darker";
}

RC_GTEST_PROP(MapImage, OfOneColourIsOfOneColourAtAnySize, ()) {
  const int width = *rc::gen::inRange(1, 40);
  const int height = *rc::gen::inRange(1, 40);
  const Grid<CellState> cells(width, height, CellState::unknown);
  const Scene scene{.space = FreeSpace(GridMap(cells))};
  const auto image = map_image(CellPaints(scene, kStyle), *rc::gen::inRange(1, 100),
                               *rc::gen::inRange(1, 100), *rc::gen::arbitrary<bool>());
  for (const std::uint32_t pixel : image.values()) RC_ASSERT(pixel == 0x808080U);
}

}  // namespace
}  // namespace wend
