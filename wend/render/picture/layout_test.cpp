#include "wend/render/picture/layout.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace wend {
namespace {

GridMap map_of_size(int width, int height, bool y_up = false) {
  return *make_grid_map(Grid<CellState>(width, height), {.y_up = y_up});
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
  const Margins axes{.left = 31, .top = 22, .right = 9, .bottom = 12};
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
  Scene scene{.space = *make_free_space(map_of_size(*rc::gen::inRange(1, 3000), 1))};
  scene.places = corners_of(scene.space, *rc::gen::inRange(1, 30));
  const double scale = *rc::gen::inRange(1, 6000) / 40.0;
  const int step = axis_step(scene, scale);
  RC_ASSERT(step % scene.places.spacing == 0);
  const double widest =
      0.6 * kAxisFontSize * static_cast<double>(std::to_string(scene.space.width()).size());
  RC_ASSERT(step * scale >= widest + 10);
  RC_ASSERT(step == scene.places.spacing || step * scale <= 2.5 * (widest + 40));
}

TEST(ScaleBar, IsARoundLengthInMetres) {
  const Frame frame{.resolution = 0.05, .metric = true};
  const ScaleBar bar = scale_bar(frame, 2, 200);  // 200 pixels are exactly 5 m
  EXPECT_EQ(bar.label, "5 m");
  EXPECT_DOUBLE_EQ(bar.pixels, 200);
  EXPECT_EQ(scale_bar(frame, 2, 199).label, "2 m");
  EXPECT_EQ(scale_bar(frame, 2, 79).label, "1 m");
  EXPECT_EQ(scale_bar(frame, 100, 200).label, "0.1 m");
  EXPECT_EQ(scale_bar(frame, 0.01, 200).label, "1000 m");
}

TEST(ScaleBar, CountsCellsWithoutMetres) {
  const Frame frame;
  EXPECT_EQ(scale_bar(frame, 10, 200).label, "20 cells");
  EXPECT_EQ(scale_bar(frame, 150, 200).label, "1 cell");
  const ScaleBar wide = scale_bar(frame, 1000, 200);
  EXPECT_EQ(wide.label, "1 cell");
  EXPECT_EQ(wide.pixels, 1000);
}

bool overlap(const PanelPlace& a, const PanelPlace& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
         b.top < a.top + a.height;
}

RC_GTEST_PROP(PanelLayout, PutsAllPanelsSideBySideInThePicture, ()) {
  std::vector<Panel> panels;
  const int count = *rc::gen::inRange(1, 10);
  for (int i = 0; i < count; ++i) {
    const Grid<CellState> cells(*rc::gen::inRange(1, 900), *rc::gen::inRange(1, 900));
    panels.push_back({"title", {.space = *make_free_space(*make_grid_map(cells))}});
  }
  const PanelLayout layout = panel_layout(panels, *rc::gen::inRange(0, 100));
  RC_ASSERT(layout.places.size() == panels.size());
  RC_ASSERT(layout.width >= 348 && layout.width <= 2000);
  for (std::size_t i = 0; i < layout.places.size(); ++i) {
    const PanelPlace& place = layout.places[i];
    RC_ASSERT(place.left >= 0 && place.left + place.width <= layout.width);
    RC_ASSERT(place.top >= 0 && place.top + place.height <= layout.height);
    RC_ASSERT(place.view.left >= place.left);
    RC_ASSERT(place.view.left + place.view.width <= place.left + place.width);
    RC_ASSERT(place.view.top + place.view.height <= place.top + place.height);
    for (std::size_t k = 0; k < i; ++k) RC_ASSERT(!overlap(place, layout.places[k]));
  }
}

TEST(PanelLayout, FillsRows) {
  const auto columns = [](int count, int width, int height) {
    const Scene scene{.space = *make_free_space(*make_grid_map(Grid<CellState>(width, height)))};
    const auto layout =
        panel_layout(std::vector<Panel>(static_cast<std::size_t>(count), {"title", scene}), 50);
    int first_row = 0;
    for (const PanelPlace& place : layout.places) first_row += place.top == layout.places[0].top;
    return first_row;
  };
  EXPECT_EQ(columns(1, 100, 100), 1);
  EXPECT_EQ(columns(2, 100, 100), 2);
  EXPECT_EQ(columns(3, 100, 100), 3);
  EXPECT_EQ(columns(3, 160, 100), 3) << "none is left empty";
  EXPECT_EQ(columns(4, 100, 80), 2);
  EXPECT_EQ(columns(6, 100, 100), 3);
  EXPECT_EQ(columns(2, 100, 10), 1) << "long maps lie one above the other";
}

}  // namespace
}  // namespace wend
