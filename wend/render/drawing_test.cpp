#include "wend/render/drawing.hpp"

#include <cairo/cairo.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

#include "wend/render/picture_layout.hpp"
#include "wend/render/text_map_test.hpp"

namespace wend {
namespace {

/// A PNG as cairo reads it back.
class Picture {
 public:
  explicit Picture(std::string_view png)
      : surface_(cairo_image_surface_create_from_png_stream(take_bytes, &png),
                 cairo_surface_destroy) {}

  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }

  std::uint32_t pixel(double x, double y) const {
    const unsigned char* bytes =
        cairo_image_surface_get_data(surface_.get()) +
        cairo_image_surface_get_stride(surface_.get()) * static_cast<std::ptrdiff_t>(y) +
        4 * static_cast<std::ptrdiff_t>(x);
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, bytes, sizeof pixel);
    return pixel & 0xFFFFFFU;
  }

 private:
  static cairo_status_t take_bytes(void* rest, unsigned char* bytes, unsigned count) {
    auto& png = *static_cast<std::string_view*>(rest);
    if (png.size() < count) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(bytes, png.data(), count);
    png.remove_prefix(count);
    return CAIRO_STATUS_SUCCESS;
  }

  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
};

Picture png_of(const Scene& scene) {
  const auto png = draw_png(scene);
  EXPECT_TRUE(png) << png.error().message();
  return Picture(*png);
}

std::string svg_of(const Scene& scene) {
  const auto svg = draw_svg(scene);
  EXPECT_TRUE(svg) << svg.error().message();
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
  Scene scene{.space = FreeSpace(map_of({
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
  const Scene scene{.space = FreeSpace(map_of({"#...", "....", "...?"}, {.y_up = true}))};
  const Picture picture = png_of(scene);
  const PictureLayout layout = picture_layout(scene.space.map());
  const double cell = layout.view.scale();
  EXPECT_EQ(picture.pixel(layout.view.left + cell / 2, layout.view.top + cell / 2), kOccupied);
  EXPECT_EQ(picture.pixel(layout.view.left + 3.5 * cell, layout.view.top + 2.5 * cell), kUnknown);
}

TEST(Drawing, ShowsTheRobotToScale) {
  Scene scene{.space = FreeSpace(map_of({".......", ".......", ".......", ".......", "......."}),
                                 {.robot_radius = 1.5})};
  scene.start = Point{3.5, 2.5};
  const Picture picture = png_of(scene);
  EXPECT_NE(pixel_at(picture, scene, {2.3, 2.4}), kFree) << "inside the disc";
  EXPECT_EQ(pixel_at(picture, scene, {1.7, 2.4}), kFree) << "outside";
}

TEST(Drawing, RingsTheNarrowestPlace) {
  Scene scene{.space = FreeSpace(map_of({".......", ".......", "......."}))};
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
  Scene scene{.space = FreeSpace(GridMap(cells))};
  std::vector<Cell> path;
  for (int x = 100; x < 1900; ++x) path.push_back({x, 150});
  scene.path = Path(std::move(path));
  const Picture picture = png_of(scene);
  EXPECT_LE(picture.width(), 1600);
  EXPECT_EQ(pixel_at(picture, scene, {1000, 150.5}), kPath);
  EXPECT_LT(pixel_at(picture, scene, {2000.5, 50}) & 0xFFU, 0x80U);
  EXPECT_EQ(pixel_at(picture, scene, {1980, 50}), kFree);
}

/// Every element is closed, in order. (No comments, no '>' in attributes.)
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n\t/", 1));
    if (tag.starts_with('?')) continue;
    if (tag.starts_with('/')) {
      if (open.empty() || "/" + open.back() != name) return false;
      open.pop_back();
    } else if (!tag.ends_with('/')) {
      open.push_back(name);
    }
  }
  return open.empty();
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(Drawing, DrawsSmallMapsAsRectanglesInASvg) {
  Scene scene{.space = FreeSpace(map_of({"..#", "..?"}))};
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

TEST(Drawing, EmbedsManySpecksAsAnImageInASvg) {
  Grid<CellState> cells(200, 200);
  for (int y = 0; y < 200; y += 2) {
    for (int x = y % 4; x < 200; x += 2) cells[{x, y}] = CellState::occupied;
  }
  const std::string svg = svg_of({.space = FreeSpace(GridMap(cells))});
  EXPECT_TRUE(well_formed(svg));
  EXPECT_TRUE(contains(svg, "<image"));
  EXPECT_LT(svg.size(), 100000U);
}

}  // namespace
}  // namespace wend
