// Rough ground under a role, in pictures of every kind.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "wend/render/picture/axis_room.hpp"
#include "wend/render/picture/drawing.hpp"
#include "wend/render/picture/picture_layout.hpp"
#include "wend/render/picture/png_picture_test.hpp"
#include "wend/render/terminal/terminal_picture.hpp"
#include "wend/render/terminal/text_map_test.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend {
namespace {

Scene searched_yard(std::optional<int> unit) {
  Scene scene{.space = FreeSpace(map_of({"5555....", "5555....", "5555....", "....5555"}))};
  scene.marked = {
      {CellRole::expanded, marked_of({"********", "********", "********", "----****"}, '*')}};
  scene.unit = unit;
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
bool contains(const std::set<std::uint32_t>& colours, const Colour& wanted) {
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
      EXPECT_TRUE(contains(both, style.stripe(5))) << choice_name(name);
      EXPECT_TRUE(contains(both, style.expanded)) << choice_name(name);
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

}  // namespace
}  // namespace wend
