#include "wend/render/picture/drawing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/png_picture_test.hpp"
#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

Picture png_of(const Scene& scene) {
  const auto png = draw_png(scene);
  EXPECT_TRUE(png) << png.error().message;
  return Picture(*png);
}

std::string svg_of(const Scene& scene) {
  const auto svg = draw_svg(scene);
  EXPECT_TRUE(svg) << svg.error().message;
  return *svg;
}

/// The pixel at a point of the map, in grid coordinates.
std::uint32_t pixel_at(const Picture& picture, const Scene& scene, Point grid) {
  const Point point = picture_layout(scene.space.map()).view.to_picture(grid);
  return picture.pixel(point.x, point.y);
}

constexpr std::uint32_t kFree = 0xFFFFFF;
constexpr std::uint32_t kOccupied = 0x2B2D33;
constexpr std::uint32_t kUnknown = 0xC6C9CE;
constexpr std::uint32_t kPath = 0x0072B2;
constexpr std::uint32_t kStart = 0x009E73;
constexpr std::uint32_t kGoal = 0xD55E00;

TEST(Drawing, ShowsCellsPathStartAndGoalInAPng) {
  Scene scene{.space = *make_free_space(map_of({
                  "....#",
                  ".##.?",
                  ".....",
              }))};
  scene.path = Path({{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 2}, {3, 2}});
  scene.start = centre_of({0, 0});
  scene.goals = {centre_of({3, 2})};
  const Picture picture = png_of(scene);
  EXPECT_EQ(picture.width(), picture_layout(scene.space.map()).width);
  EXPECT_EQ(picture.height(), picture_layout(scene.space.map()).height);
  EXPECT_EQ(pixel_at(picture, scene, {4.5, 0.5}), kOccupied);
  EXPECT_EQ(pixel_at(picture, scene, {4.5, 1.5}), kUnknown);
  EXPECT_EQ(pixel_at(picture, scene, {3.5, 0.5}), kFree);
  EXPECT_EQ(pixel_at(picture, scene, {0.5, 0.5}), kStart);
  EXPECT_EQ(pixel_at(picture, scene, {3.5, 2.5}), kGoal);
  EXPECT_EQ(pixel_at(picture, scene, {0.5, 1.5}), kPath);
  EXPECT_EQ(pixel_at(picture, scene, {1.5, 2.5}), kPath);
}

TEST(Drawing, DrawsMapsWithYUpAsTheFileLooks) {
  const Scene scene{.space = *make_free_space(map_of({"#...", "....", "...?"}, {.y_up = true}))};
  const Picture picture = png_of(scene);
  const PictureLayout layout = picture_layout(scene.space.map());
  const double cell = layout.view.scale();
  EXPECT_EQ(picture.pixel(layout.view.left + cell / 2, layout.view.top + cell / 2), kOccupied);
  EXPECT_EQ(picture.pixel(layout.view.left + 3.5 * cell, layout.view.top + 2.5 * cell), kUnknown);
}

TEST(Drawing, ShowsTheRobotToScale) {
  Scene scene{.space =
                  *make_free_space(map_of({".......", ".......", ".......", ".......", "......."}),
                                   {.footprint = Footprint::disc(1.5)})};
  scene.start = Point{3.5, 2.5};
  const Picture picture = png_of(scene);
  EXPECT_NE(pixel_at(picture, scene, {2.3, 2.4}), kFree) << "inside the disc";
  EXPECT_EQ(pixel_at(picture, scene, {1.7, 2.4}), kFree) << "outside";
}

TEST(Drawing, RingsTheNarrowestPlace) {
  Scene scene{.space = *make_free_space(map_of({".......", ".......", "......."}))};
  scene.narrowest = Point{3.5, 1.5};
  const Picture picture = png_of(scene);
  const double ring = 1.3 * 18 / picture_layout(scene.space.map()).view.scale();
  EXPECT_EQ(pixel_at(picture, scene, {3.5, 1.5}), kFree) << "one sees what lies there";
  EXPECT_EQ(pixel_at(picture, scene, {3.5 + ring, 1.5}), 0x7D0552U);
  EXPECT_EQ(pixel_at(picture, scene, {3.5, 1.5 - ring}), 0x7D0552U);
}

TEST(Drawing, ShrinksHugeMapsAndKeepsThinWallsAndThePathVisible) {
  Grid<CellState> cells(4096, 300);
  for (int y = 0; y < 300; ++y) cells[{2000, y}] = CellState::occupied;
  Scene scene{.space = *make_free_space(*make_grid_map(cells))};
  std::vector<Cell> path;
  for (int x = 100; x < 1900; ++x) path.push_back({x, 150});
  scene.path = Path(std::move(path));
  const Picture picture = png_of(scene);
  EXPECT_LE(picture.width(), 1600);
  EXPECT_EQ(pixel_at(picture, scene, {1000, 150.5}), kPath);
  EXPECT_LT(pixel_at(picture, scene, {2000.5, 50}) & 0xFFU, 0x80U);
  EXPECT_EQ(pixel_at(picture, scene, {1980, 50}), kFree);
}

TEST(Drawing, DrawsSmallMapsAsRectanglesInASvg) {
  Scene scene{.space = *make_free_space(map_of({"..#", "..?"}))};
  scene.path = Path({{0, 0}, {1, 1}});
  scene.start = centre_of({0, 0});
  scene.goals = {centre_of({1, 1})};
  const std::string svg = svg_of(scene);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_TRUE(svg.starts_with("<?xml")) << svg;
  EXPECT_FALSE(contains(svg, "<image"));
  for (const char* colour :
       {"44.705882%", "61.960784%", "83.529412%", "16.862745%", "77.647059%"}) {
    EXPECT_TRUE(contains(svg, colour)) << colour << " of path, start, goal, obstacle or unknown";
  }
  EXPECT_LT(svg.size(), 30000U);
}

/// A room of 10 x 6 cells with costs and moves to its left.
Scene field() {
  Scene scene{.space = *make_free_space(*make_grid_map(Grid<CellState>(10, 6)))};
  scene.heatmap = {"cost to the goal", Grid<double>(10, 6)};
  scene.arrows.emplace(10, 6, Direction::minus_x);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 10; ++x) scene.heatmap->values[{x, y}] = 1000 * x;
  }
  return scene;
}

TEST(Drawing, ExplainsEverythingOnAsManyLinesAsItTakes) {
  Scene scene = field();
  const int one_line = png_of({.space = scene.space}).height();
  scene.heatmap->title = "number of times that each of the cells was reached";
  scene.start = centre_of({1, 1});
  scene.goals = {centre_of({8, 1})};
  scene.narrowest = centre_of({4, 4});
  BitGrid some(10, 6);
  some.set({3, 3}, true);
  for (std::size_t role = 0; role < kCellRoles; ++role) {
    scene.marked.push_back({static_cast<CellRole>(role), some});
  }
  const Picture picture = png_of(scene);
  EXPECT_GT(picture.height(), one_line + 33) << "more than one line";
  EXPECT_LT(picture.height(), one_line + 200);
}

TEST(Drawing, WritesNumbersOnlyIntoCellsThatAreLargeEnough) {
  const Scene large = field();
  Scene plain = large;
  plain.arrows.reset();
  const Picture numbered = png_of(plain);
  const MapView view = picture_layout(large.space.map()).view;
  ASSERT_GE(view.scale(), 30);
  const auto inked = [&](const Picture& picture, Cell cell) {
    int pixels = 0;
    const std::uint32_t corner = pixel_at(picture, large, {cell.x + 0.1, cell.y + 0.1});
    for (double dy = 0.1; dy < 0.9; dy += 0.02) {
      for (double dx = 0.1; dx < 0.9; dx += 0.02) {
        pixels += pixel_at(picture, large, {cell.x + dx, cell.y + dy}) != corner;
      }
    }
    return pixels;
  };
  EXPECT_GT(inked(numbered, {5, 2}), inked(numbered, {0, 2})) << "5000 has more digits than 0";
  EXPECT_GT(inked(numbered, {0, 2}), 10);

  Scene small{.space = *make_free_space(*make_grid_map(Grid<CellState>(60, 60)))};
  small.heatmap = {"cost", Grid<double>(60, 60, 1.0)};
  const Picture picture = png_of(small);
  for (double x = 0.1; x < 60; x += 0.21) {
    const std::uint32_t pixel = pixel_at(picture, small, {x, 30.5});
    EXPECT_GT(pixel & 0xFFU, 0x90U) << "heat and grid lines alone, at " << x;
  }
}

TEST(Drawing, SharesArrowsAmongCellsThatAreTooSmallForOneEach) {
  Scene scene{.space = *make_free_space(*make_grid_map(Grid<CellState>(400, 400)))};
  scene.arrows.emplace(400, 400, Direction::plus_x);
  const Picture picture = png_of(scene);
  int arrows = 0;  // along a row of middle cells, by their shafts
  bool before = false;
  for (double x = 0; x < 400; x += 0.25) {
    const bool ink = pixel_at(picture, scene, {x, 2.5}) != kFree;
    arrows += ink && !before;
    before = ink;
  }
  EXPECT_EQ(arrows, 80) << "15 pixels are five cells";
}

TEST(Drawing, WritesAPdfOfOnePageOfThePicturesSize) {
  const Scene scene = field();
  const auto pdf = draw_pdf(scene);
  ASSERT_TRUE(pdf);
  const auto again = draw_pdf(scene);
  EXPECT_EQ(*pdf, *again);
  EXPECT_TRUE(pdf->starts_with("%PDF-1."));
  EXPECT_TRUE(pdf->ends_with("%%EOF\n"));
  const Picture png = png_of(scene);
  EXPECT_TRUE(contains(
      *pdf, fmt::format("/MediaBox [ 0 0 {:g} {:g} ]", png.width() * 0.75, png.height() * 0.75)));
}

TEST(Drawing, GivesPixelsForAnimations) {
  Scene scene{.space = *make_free_space(map_of({"#..", "..?"}))};
  const auto pixels = draw_pixels(scene, 100, 100);
  EXPECT_EQ(pixels.width(), 99);
  EXPECT_EQ(pixels.height(), 66);
  EXPECT_EQ((pixels[{3, 3}]), kOccupied);
  EXPECT_EQ((pixels[{96, 63}]), kUnknown);
  EXPECT_EQ((pixels[{50, 16}]), kFree);
  scene.start = centre_of({1, 0});
  const auto explained = draw_pixels(scene, 300, 200, {}, PixelLegend::below);
  EXPECT_EQ(explained.width(), 300);
  EXPECT_LE(explained.height(), 200);
  EXPECT_EQ((explained[{explained.width() - 1, explained.height() - 1}]), 0xFFFFFFU);
}

TEST(Drawing, ShrinksMapsToPixels) {
  const Scene scene{.space = *make_free_space(*make_grid_map(Grid<CellState>(3000, 1000)))};
  const auto pixels = draw_pixels(scene, 600, 500);
  EXPECT_EQ(pixels.width(), 600);
  EXPECT_EQ(pixels.height(), 200);
  EXPECT_EQ((draw_pixels(scene, 0, -5).size()), 1U);
}

TEST(Drawing, EmbedsManySpecksAsAnImageInASvg) {
  Grid<CellState> cells(200, 200);
  for (int y = 0; y < 200; y += 2) {
    for (int x = y % 4; x < 200; x += 2) cells[{x, y}] = CellState::occupied;
  }
  const std::string svg = svg_of({.space = *make_free_space(*make_grid_map(cells))});
  EXPECT_TRUE(well_formed(svg));
  EXPECT_TRUE(contains(svg, "<image"));
  EXPECT_LT(svg.size(), 100000U);
}

}  // namespace
}  // namespace wend
