// Lines, the robot and collisions, in pictures of every kind.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "wend/render/legend.hpp"
#include "wend/render/picture/drawing.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/png_picture_test.hpp"
#include "wend/render/terminal/terminal_picture.hpp"
#include "wend/render/terminal/text_map_test.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend {
namespace {

constexpr std::uint32_t kFloor = 0xFFFFFF;

FreeSpace open_space(FreeSpaceOptions options = {}) {
  return *make_free_space(map_of({
                              ".......",
                              ".......",
                              ".......",
                              ".......",
                              ".......",
                          }),
                          options);
}

/// The pixels at points of the map, in grid coordinates.
std::vector<std::uint32_t> pixels_at(const Scene& scene, const std::vector<Point>& places) {
  const auto png = draw_png(scene);
  EXPECT_TRUE(png);
  const Picture picture(*png);
  std::vector<std::uint32_t> pixels;
  for (const Point place : places) {
    const Point point = picture_layout(scene.space.map()).view.to_picture(place);
    pixels.push_back(picture.pixel(point.x, point.y));
  }
  return pixels;
}

std::uint32_t pixel_at(const Scene& scene, Point place) {
  return pixels_at(scene, {place}).front();
}

Scene crossing_lines() {
  Scene scene{.space = open_space()};
  scene.lines = {{LineRole::smoothed, {{1, 1.3}, {6, 1.3}}},
                 {LineRole::driven, {{3.7, 0.5}, {3.7, 4.5}}}};
  return scene;
}

/// An arc to the left, after a line ahead.
Scene with_motions() {
  Scene scene{.space = open_space()};
  scene.motions.add(std::vector<Pose>{{1, 1, 0}});
  scene.motions.add(std::vector<Pose>{{1, 1, 0}, {4, 1, 0}});
  scene.motions.add(std::vector<Pose>{{4, 1, 0}, {6, 3, std::numbers::pi / 2}});
  scene.heatmap = {"order of expansion", Grid<double>(7, 5, 1.0), HeatRange{1, 3}};
  return scene;
}

TEST(SceneMotions, HaveTheColoursOfTheHeatmapInPlaceOfItsCells) {
  const Style style;
  const Scene scene = with_motions();
  const double aside = std::numbers::sqrt2;  // of the middle of a quarter of a circle of radius 2
  const auto pixels =
      pixels_at(scene, {{2.5, 1}, {4 + aside, 3 - aside}, {1.15, 3.15}, {5.3, 2.3}});
  EXPECT_EQ(pixels[0], rgb_of(style.heat(0.5)));
  EXPECT_EQ(pixels[1], rgb_of(style.heat(1)));
  EXPECT_EQ(pixels[2], kFloor);
  EXPECT_EQ(pixels[3], kFloor) << "the chord of the arc";
  Scene without = scene;
  without.motions.clear();
  EXPECT_EQ(pixel_at(without, {1.15, 3.15}), rgb_of(style.heat(0)));
}

TEST(SceneMotions, AreNamedByTheHeatmapAndCountTheirRange) {
  const auto legend = legend_of(with_motions(), Style{});
  ASSERT_FALSE(legend.empty());
  EXPECT_EQ(legend.front().swatch, Swatch::heat);
  EXPECT_EQ(legend.front().label, "order of expansion");
  EXPECT_EQ(legend.front().range, (HeatRange{1, 3}));
}

TEST(SceneLines, DashAPossiblePathInThePathsColourAndNameIt) {
  Scene scene{.space = open_space()};
  scene.lines = {{LineRole::possible, {{0.5, 2.5}, {6.5, 2.5}}, "path for a robot of 2 cells"}};
  std::vector<Point> along;
  for (double x = 1; x < 6; x += 0.02) along.push_back({x, 2.5});
  const auto pixels = pixels_at(scene, along);
  const std::uint32_t path = rgb_of(Style{}.path);
  EXPECT_NE(std::ranges::count(pixels, path), 0);
  EXPECT_NE(std::ranges::count(pixels, kFloor), 0) << "gaps";
  const LegendItem item = legend_of(scene, {}).front();
  EXPECT_EQ(item.swatch, Swatch::possible_line);
  EXPECT_EQ(item.label, "path for a robot of 2 cells");
  EXPECT_EQ(text_picture(scene, {.legend = true}),
            ".......\n.......\n◇◇◇◇◇◇◇\n.......\n.......\n"
            "◇ path for a robot of 2 cells   . free\n");
}

TEST(SceneLines, DashAPossiblePathInHalfBlocksToo) {
  Scene scene{.space = *make_free_space(*make_grid_map(Grid<CellState>(60, 3, CellState::free)))};
  const Terminal terminal{.graphics = TerminalGraphics::half_blocks,
                          .colours = TerminalColours::true_colour};
  scene.lines = {{LineRole::possible, {{0.5, 1.5}, {59.5, 1.5}}}};
  const std::string dashed = terminal_picture(scene, 60, 10, terminal);
  scene.lines = {};
  scene.path = Path({{0, 1}, {59, 1}});
  EXPECT_NE(dashed, terminal_picture(scene, 60, 10, terminal));
  const auto changes = [](const std::string& text) { return std::ranges::count(text, '\x1b'); };
  EXPECT_GT(changes(dashed), changes(terminal_picture(scene, 60, 10, terminal)) + 10);
}

TEST(SceneMarks, ShowTheNearestFreeCell) {
  Scene scene{.space = open_space()};
  scene.nearest_free = {{2, 1}, {40, 1}};  // the other one is outside the map
  EXPECT_EQ(pixel_at(scene, {2.5, 1.5}), rgb_of(Style{}.narrowest));
  EXPECT_EQ(legend_of(scene, {}).front().label, "nearest free cell");
  EXPECT_EQ(text_picture(scene, {.legend = true}),
            ".......\n..N....\n.......\n.......\n.......\nN nearest free cell   . free\n");
}

TEST(SceneLines, LieExactlyWhereTheirPointsAreInTheirColours) {
  const Scene scene = crossing_lines();
  EXPECT_EQ(pixel_at(scene, {2, 1.3}), rgb_of(Style{}.lines.smoothed));
  EXPECT_EQ(pixel_at(scene, {3.7, 4}), rgb_of(Style{}.lines.driven));
  EXPECT_EQ(pixel_at(scene, {3.7, 1.3}), rgb_of(Style{}.lines.driven)) << "later ones are on top";
  EXPECT_EQ(pixel_at(scene, {2.3, 1.6}), kFloor);
}

TEST(SceneLines, ThatAreDrivenLeaveSmoothedOnesToBeSeen) {
  Scene scene{.space = open_space()};
  scene.lines = {{LineRole::smoothed, {{1, 2.5}, {6, 2.5}}},
                 {LineRole::driven, {{1, 2.5}, {6, 2.5}}}};
  EXPECT_EQ(pixel_at(scene, {3, 2.5}), rgb_of(Style{}.lines.driven));
  const double aside = 3.0 / picture_layout(scene.space.map()).view.scale();
  EXPECT_EQ(pixel_at(scene, {3, 2.5 + aside}), rgb_of(Style{}.lines.smoothed));
}

TEST(SceneLines, DashWhatIsPlanned) {
  Scene scene{.space = open_space()};
  scene.lines = {{LineRole::planned, {{0.5, 2.5}, {6.5, 2.5}}}};
  std::vector<Point> along;
  for (double x = 1; x < 6; x += 0.02) along.push_back({x, 2.5});
  const std::vector<std::uint32_t> pixels = pixels_at(scene, along);
  const auto red = std::ranges::count(pixels, rgb_of(Style{}.lines.planned));
  const auto others = static_cast<std::ptrdiff_t>(pixels.size()) - red;
  EXPECT_GT(red, 25);
  EXPECT_GT(others, 25);
}

TEST(SceneLines, OfWaypointsAreSharpWhereThoseOfCellsAreRound) {
  Scene scene{.space = open_space()};
  scene.path = Path({{1, 1}, {2, 1}, {3, 1}, {3, 2}, {3, 3}});
  const std::uint32_t path = rgb_of(Style{}.path);
  EXPECT_NE(pixel_at(scene, {3.5, 1.5}), path);
  scene.path = Path::along({{1.5, 1.5}, {3.5, 1.5}, {3.5, 3.5}});
  EXPECT_EQ(pixel_at(scene, {3.5, 1.5}), path);
  EXPECT_EQ(pixel_at(scene, {2, 1.5}), path);
}

TEST(SceneLines, ShowTheRobotToScaleAndWhereItHeads) {
  Scene scene{.space = open_space({.footprint = Footprint::disc(1.5)})};
  scene.start = Point{5.5, 1};
  scene.robot = Pose{2.5, 2.5, std::numbers::pi / 2};
  const std::uint32_t blue = rgb_of(Style{}.lines.driven);
  EXPECT_NE(pixel_at(scene, {1.4, 2.5}), kFloor) << "inside the disc";
  EXPECT_EQ(pixel_at(scene, {1.0, 2.5}), blue) << "its edge";
  EXPECT_EQ(pixel_at(scene, {2.5, 3.2}), blue) << "its heading, down where y is down";
  EXPECT_NE(pixel_at(scene, {2.5, 1.8}), blue);
  EXPECT_EQ(pixel_at(scene, {4.6, 1.6}), 0xFFFFFFU) << "no second disc at the start";
}

TEST(SceneLines, CrossOutACollision) {
  Scene scene{.space = open_space()};
  scene.collision = Point{2.5, 2.5};
  const std::uint32_t mark = rgb_of(Style{}.narrowest);
  const double reach = 0.5 * 18 / picture_layout(scene.space.map()).view.scale();
  EXPECT_EQ(pixel_at(scene, {2.5, 2.5}), mark);
  EXPECT_EQ(pixel_at(scene, {2.5 + reach, 2.5 - reach}), mark);
  EXPECT_EQ(pixel_at(scene, {2.5 + reach, 2.5}), kFloor);
}

TEST(SceneLines, AreInTheLegendOnceEach) {
  Scene scene = crossing_lines();
  scene.lines.push_back({LineRole::planned, {{1, 1}, {2, 2}}});
  scene.lines.push_back({LineRole::driven, {{1, 1}, {2, 2}}});
  scene.collision = Point{1, 1};
  std::string labels;
  for (const LegendItem& item : legend_of(scene, {})) {
    labels += std::string(1, item.character) + item.label + " ";
  }
  EXPECT_EQ(labels, "Xcollision oplanned %smoothed &driven ");
}

TEST(SceneLines, AreCharactersInText) {
  Scene scene = crossing_lines();
  scene.lines.insert(scene.lines.begin(), {LineRole::planned, {{0.5, 3.5}, {6.5, 3.5}}});
  scene.robot = Pose{3.7, 4.5, 0};
  scene.collision = Point{6.5, 3.5};
  EXPECT_EQ(text_picture(scene, {.legend = true}), lines_of({
                                                       "...◆...",
                                                       ".●●◆●●●",
                                                       "...◆...",
                                                       "○○○◆○○✗",
                                                       "...R...",
                                                       "○ planned   ● smoothed   ◆ driven   "
                                                       "R robot   ✗ collision   . free",
                                                   }));
  EXPECT_EQ(text_picture(scene, {.legend = true, .ascii = true}),
            lines_of({
                "...&...",
                ".%%&%%%",
                "...&...",
                "ooo&ooX",
                "...R...",
                "o planned   % smoothed   & driven   R robot   X collision   . free",
            }));
}

TEST(SceneLines, AreCharactersOfLargeMapsToo) {
  const Scene scene = crossing_lines();
  EXPECT_EQ(ascii_picture(scene, 7, 3), lines_of({".%%&%%%", "...&...", "...&..."}));
  EXPECT_EQ(terminal_legend(scene, 80, {}), "% smoothed   & driven\n");
}

TEST(SceneLines, OutsideTheMapAreLeftOut) {
  Scene scene{.space = open_space()};
  scene.lines = {{LineRole::driven, {{-3, 2.5}, {20, 2.5}}}};
  scene.robot = Pose{-5, 2.5, 0};
  scene.collision = Point{-5, 2.5};
  EXPECT_EQ(pixel_at(scene, {3, 2.5}), rgb_of(Style{}.lines.driven));
  EXPECT_EQ(ascii_picture(scene, 7, 3), lines_of({".......", "&&&&&&&", "......."}));
  EXPECT_EQ(text_picture(scene), lines_of({".......", ".......", "◆◆◆◆◆◆◆", ".......", "......."}));
}

}  // namespace
}  // namespace wend
