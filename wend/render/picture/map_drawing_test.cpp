// The map in pictures, and rough ground under a role in those of every kind.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "wend/render/picture/drawing.hpp"
#include "wend/render/picture/drawn_cells.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/png_picture_test.hpp"
#include "wend/render/terminal/terminal_picture.hpp"
#include "wend/render/terminal/text_map_test.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend {
namespace {

constexpr Style kStyle{.free = colour_from(0xFFFFFF),
                       .occupied = colour_from(0x000000),
                       .unknown = colour_from(0x808080)};

std::uint32_t pixel_of(const Grid<std::uint32_t>& image, int x, int y) { return image[{x, y}]; }

TEST(MapImage, EnlargesCellsToCrispSquares) {
  const Scene scene{.space = *make_free_space(map_of({"#.", ".?"}))};
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
  const Scene scene{.space = *make_free_space(map_of({"#..", "...", "..?"}, {.y_up = true}))};
  const auto image = map_image(CellPaints(scene, kStyle), 3, 3, true);
  EXPECT_EQ(pixel_of(image, 0, 0), 0x000000U);
  EXPECT_EQ(pixel_of(image, 2, 2), 0x808080U);
  EXPECT_EQ(pixel_of(image, 0, 2), 0xFFFFFFU);
}

TEST(MapImage, KeepsThinWallsVisibleWhenItShrinks) {
  Grid<CellState> cells(64, 64);
  for (int y = 0; y < 64; ++y) cells[{21, y}] = CellState::occupied;
  const Scene scene{.space = *make_free_space(*make_grid_map(cells))};
  const auto image = map_image(CellPaints(scene, kStyle), 8, 8, false);
  for (int y = 0; y < 8; ++y) {
    EXPECT_LT(pixel_of(image, 2, y) & 0xFFU, 0xC0U);  // cells 16 to 23
    EXPECT_EQ(pixel_of(image, 1, y), 0xFFFFFFU);
    EXPECT_EQ(pixel_of(image, 3, y), 0xFFFFFFU);
  }
}

TEST(MapImage, MixesTheCellsUnderAPixelByTheAreaTheyShare) {
  const Scene scene{.space = *make_free_space(map_of({".?."}))};
  const auto image = map_image(CellPaints(scene, kStyle), 2, 1, false);
  // Each pixel is two thirds of a free cell and one third of the unknown one.
  EXPECT_EQ(pixel_of(image, 0, 0), 0xD5D5D5U);
  EXPECT_EQ(pixel_of(image, 1, 0), 0xD5D5D5U);
}

TEST(MapImage, PaintsTooCloseExpandedAndRoughCells) {
  Scene scene{.space = *make_free_space(map_of({"#..2.9"}), {.footprint = Footprint::disc(1)})};
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
  const Scene scene{.space = *make_free_space(*make_grid_map(cells))};
  const auto image = map_image(CellPaints(scene, kStyle), *rc::gen::inRange(1, 100),
                               *rc::gen::inRange(1, 100), *rc::gen::arbitrary<bool>());
  for (const std::uint32_t pixel : image.values()) RC_ASSERT(pixel == 0x808080U);
}

constexpr std::size_t kAny = 1000000;

std::vector<MapRectangle> rectangles_of(const Scene& scene) {
  const Style style;
  return map_rectangles(CellPaints(scene, style), style.free, kAny).value();
}

TEST(MapRectangles, MergeRunsAndEqualRunsBelow) {
  const Style style;
  const Scene scene{.space = *make_free_space(map_of({
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
  const Scene scene{.space = *make_free_space(map_of({"#.#", ".#."}))};
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
  const Scene scene{.space = *make_free_space(*make_grid_map(cells))};
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

Scene searched_yard(std::optional<int> unit) {
  Scene scene{.space = *make_free_space(map_of({"5555....", "5555....", "5555....", "....5555"}))};
  scene.marked = {
      {CellRole::expanded, marked_of({"********", "********", "********", "----****"}, '*')}};
  if (unit) scene.places = corners_of(scene.space, *unit);
  return scene;
}

/// The colours of all pixels inside a cell, away from its edges.
std::set<std::uint32_t> colours_in(const Scene& scene, Cell cell, const Style& style) {
  const Picture picture(*draw_png(scene, style));
  const MapView view = picture_layout(scene.space.map(), axis_room(scene)).view;
  std::set<std::uint32_t> colours;
  for (double x = 0.1; x < 0.9; x += 0.02) {
    for (double y = 0.1; y < 0.9; y += 0.02) {
      const Point point = view.to_picture({cell.x + x, cell.y + y});
      colours.insert(picture.pixel(point.x, point.y));
    }
  }
  return colours;
}

/// But for rounding.
bool shows(const std::set<std::uint32_t>& colours, const Colour& wanted) {
  return std::ranges::any_of(colours, [&](std::uint32_t rgb) {
    const Colour colour = colour_from(rgb);
    return std::abs(colour.red - wanted.red) < 0.01 &&
           std::abs(colour.green - wanted.green) < 0.01 &&
           std::abs(colour.blue - wanted.blue) < 0.01;
  });
}

TEST(Stripes, ShowRoughGroundAndTheRoleOverIt) {
  for (const StyleName name : {StyleName::light, StyleName::dark, StyleName::print}) {
    const Style style = style_of(name);
    for (const std::optional<int> unit : {std::optional<int>(), std::optional(1)}) {
      const Scene scene = searched_yard(unit);
      const auto both = colours_in(scene, {1, 1}, style);
      EXPECT_TRUE(shows(both, style.stripe(5))) << choice_name(name);
      EXPECT_TRUE(shows(both, style.expanded)) << choice_name(name);
      EXPECT_EQ(colours_in(scene, {6, 1}, style), std::set{rgb_of(style.expanded)});
    }
  }
}

TEST(Stripes, AreInSvgToo) {
  const auto striped = draw_svg(searched_yard({}));
  Scene plain = searched_yard({});
  plain.marked.clear();
  ASSERT_TRUE(striped);
  EXPECT_GT(striped->size(), draw_svg(plain)->size());
}

TEST(Stripes, AreBlendedWhereATerminalHasNoRoomForThem) {
  const Terminal terminal{TerminalGraphics::half_blocks, TerminalColours::true_colour};
  const std::uint32_t rgb = rgb_of(Style{}.of(CellRole::expanded, 5));
  const std::string code = "2;" + std::to_string(rgb >> 16U) + ";" +
                           std::to_string(rgb >> 8U & 255U) + ";" + std::to_string(rgb & 255U);
  EXPECT_NE(terminal_picture(searched_yard({}), 8, 4, terminal).find(code), std::string::npos);
  EXPECT_NE(terminal_legend(searched_yard({}), 80, terminal).find("expanded, rough"),
            std::string::npos);
}

TEST(Stripes, AreACharacterOfTheirOwnInText) {
  EXPECT_EQ(text_picture(searched_yard({}), {.legend = true}),
            "%%%%****\n%%%%****\n%%%%****\n....%%%%\n"
            "* expanded   % expanded, rough   . free\n");
  EXPECT_NE(text_picture(searched_yard(1), {.legend = true}).find("% expanded, rough"),
            std::string::npos);
}

Scene yard(int width, int height, bool y_up = false) {
  Scene scene{.space =
                  *make_free_space(*make_grid_map(Grid<CellState>(width, height), {.y_up = y_up}))};
  scene.places = corners_of(scene.space);
  return scene;
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
    const Margins room = axis_room(scene);
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
  scene.places = {};
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
