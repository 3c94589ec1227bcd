#include "wend/render/picture/picture_layout.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace wend {
namespace {

GridMap map_of_size(int width, int height, bool y_up = false) {
  return GridMap(Grid<CellState>(width, height), {.y_up = y_up});
}

RC_GTEST_PROP(PictureLayout, LargerSideIsBetween800And1600, ()) {
  const int longer = *rc::gen::inRange(1, 5000);
  const int shorter = *rc::gen::inRange(1, std::min(longer, 50) + 1);
  const bool wide = *rc::gen::arbitrary<bool>();
  const PictureLayout layout =
      picture_layout(wide ? map_of_size(longer, shorter) : map_of_size(shorter, longer));
  const int longer_side = std::max(layout.width, layout.height);
  RC_ASSERT(longer_side >= 800);
  RC_ASSERT(longer_side <= 1600);
  RC_ASSERT(layout.view.width >= 1 && layout.view.height >= 1);
  RC_ASSERT(layout.view.left + layout.view.width <= layout.width);
  RC_ASSERT(layout.view.top + layout.view.height <= layout.height);
}

TEST(PictureLayout, EnlargesByWholeNumbers) {
  for (const int side : {1, 7, 30, 99, 256, 500, 752, 753, 1504}) {
    const MapView view = picture_layout(map_of_size(side, 1)).view;
    EXPECT_EQ(view.width % side, 0) << side;
    EXPECT_EQ(view.scale(), std::floor(view.scale())) << side;
    EXPECT_EQ(view.left, std::floor(view.left)) << side;
  }
}

TEST(PictureLayout, LeavesRoomForAxes) {
  const GridMap map = map_of_size(20, 30);
  const AxisRoom axes{.left = 31, .top = 22, .right = 9, .bottom = 12};
  const PictureLayout plain = picture_layout(map);
  const PictureLayout layout = picture_layout(map, axes);
  EXPECT_EQ(layout.view.width, plain.view.width);
  EXPECT_GE(layout.view.left, 31 + PictureLayout::kMargin);
  EXPECT_LE(layout.view.left + layout.view.width + 9 + PictureLayout::kMargin, layout.width);
  EXPECT_EQ(layout.view.top, plain.view.top + 22);
  EXPECT_EQ(layout.height, plain.height + 22 + 12);
  EXPECT_EQ(layout.footer().y, plain.footer().y + 22 + 12);
}

TEST(MapView, PutsGridPointsWhereTheFileHasThem) {
  const MapView down{.left = 10, .top = 20, .width = 40, .height = 20, .columns = 4, .rows = 2};
  EXPECT_EQ(down.to_picture({0, 0}), (Point{10, 20}));
  EXPECT_EQ(down.to_picture({4, 2}), (Point{50, 40}));
  EXPECT_EQ(down.to_picture({0.5, 0.5}), (Point{15, 25}));
  MapView up = down;
  up.y_up = true;
  EXPECT_EQ(up.to_picture({0, 0}), (Point{10, 40}));
  EXPECT_EQ(up.to_picture({0.5, 0.5}), (Point{15, 35}));
}

}  // namespace
}  // namespace wend
