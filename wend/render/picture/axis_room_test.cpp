#include "wend/render/picture/axis_room.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "wend/render/picture/drawing.hpp"
#include "wend/render/picture/round_step.hpp"

namespace wend {
namespace {

Scene yard(int width, int height, bool y_up = false) {
  Scene scene{.space = FreeSpace(GridMap(Grid<CellState>(width, height), {.y_up = y_up}))};
  scene.unit = 1;
  return scene;
}

TEST(RoundStep, IsTheLeastThatIsNotLess) {
  EXPECT_EQ(round_step(0), 1);
  EXPECT_EQ(round_step(1), 1);
  EXPECT_EQ(round_step(1.01), 2);
  EXPECT_EQ(round_step(2), 2);
  EXPECT_EQ(round_step(3), 5);
  EXPECT_EQ(round_step(5.5), 10);
  EXPECT_EQ(round_step(11), 20);
  EXPECT_EQ(round_step(201), 500);
  EXPECT_EQ(round_step(1e30), 1'000'000'000);
}

RC_GTEST_PROP(Axes, NumberCornersSoThatNumbersNeverTouch, ()) {
  Scene scene = yard(*rc::gen::inRange(1, 3000), 1);
  scene.unit = *rc::gen::inRange(1, 30);
  const double scale = *rc::gen::inRange(1, 6000) / 40.0;
  const int step = axis_step(scene, scale);
  RC_ASSERT(step % *scene.unit == 0);
  const double widest =
      0.6 * kAxisFontSize * static_cast<double>(std::to_string(scene.space.width()).size());
  RC_ASSERT(step * scale >= widest + 10);
  RC_ASSERT(step == *scene.unit || step * scale <= 2.5 * (widest + 40));
}

/// How many pixels of a part of a picture are not of the page's colour.
int ink(const Grid<std::uint32_t>& picture, int left, int top, int right, int bottom) {
  int count = 0;
  for (int y = std::max(0, top); y < std::min(bottom, picture.height()); ++y) {
    for (int x = std::max(0, left); x < std::min(right, picture.width()); ++x) {
      count += picture[{x, y}] != rgb_of(Style{}.page);
    }
  }
  return count;
}

TEST(Axes, LieBesideRowZeroAndAtTheLeft) {
  constexpr int kSize = 400;
  for (const bool y_up : {false, true}) {
    const Scene scene = yard(20, 20, y_up);
    const AxisRoom room = axis_room(scene);
    const auto picture = draw_pixels(scene, kSize, kSize);
    const int width = picture.width();
    const int height = picture.height();
    EXPECT_GT(ink(picture, 0, room.top, room.left - 6, height - room.bottom), 100) << "rows";
    const int above = ink(picture, room.left, 0, width, room.top - 6);
    const int below = ink(picture, room.left, height - room.bottom + 6, width, height);
    EXPECT_GT(y_up ? below : above, 100) << "columns, y_up " << y_up;
    EXPECT_EQ(y_up ? above : below, 0);
  }
}

TEST(Axes, AreOnlyWhereACarStandsOnCorners) {
  Scene scene = yard(20, 20);
  scene.unit.reset();
  EXPECT_EQ(axis_room(scene).across() + axis_room(scene).down(), 0);
  EXPECT_EQ(draw_pixels(scene, 400, 400).width(), 400);
}

TEST(Axes, LeaveRoomForAMapInTheSmallestPictures) {
  const auto picture = draw_pixels(yard(20, 20), 5, 5);
  EXPECT_GE(picture.width(), 1);
  EXPECT_GE(picture.height(), 1);
}

}  // namespace
}  // namespace wend
