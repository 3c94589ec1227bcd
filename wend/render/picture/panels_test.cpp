#include "wend/render/picture/panels.hpp"

#include <gtest/gtest.h>

#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/png_picture_test.hpp"
#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

Scene heated(double greatest, std::string title = "cost") {
  Scene scene{.space = *make_free_space(map_of({"..#", "..."}))};
  scene.heatmap = {std::move(title), Grid<double>(3, 2)};
  scene.heatmap->values[{1, 0}] = greatest;
  return scene;
}

Picture png_of(const std::vector<Panel>& panels, const Style& style = {}) {
  const auto png = draw_panels(panels, PictureKind::png, style);
  EXPECT_TRUE(png) << png.error().message;
  return Picture(*png);
}

std::uint32_t pixel_at(const Picture& picture, const PanelPlace& place, Point grid) {
  const Point point = place.view.to_picture(grid);
  return picture.pixel(point.x, point.y);
}

TEST(Panels, CompareHeatmapsOfOneTitleInOneRange) {
  const Style style;
  const std::vector<Panel> panels{{"a", heated(100)}, {"b", heated(50)}, {"c", heated(2, "other")}};
  const Picture picture = png_of(panels);
  const auto places = panel_layout(panels, 0).places;
  const Point hot{1.2, 0.2};
  EXPECT_EQ(pixel_at(picture, places[0], hot), rgb_of(style.heat(1)));
  EXPECT_EQ(pixel_at(picture, places[1], hot), rgb_of(style.heat(0.5)));
  EXPECT_EQ(pixel_at(picture, places[2], hot), rgb_of(style.heat(1)));
}

TEST(Panels, MayHaveStylesOfTheirOwn) {
  const Style dark = style_of(StyleName::dark);
  const std::vector<Panel> panels{{"a", heated(1)}, {"b", heated(1), "", dark}};
  const Picture picture = png_of(panels);
  const auto places = panel_layout(panels, 34).places;
  const Point wall{2.5, 0.5};
  EXPECT_EQ(pixel_at(picture, places[0], wall), rgb_of(Style{}.occupied));
  EXPECT_EQ(pixel_at(picture, places[1], wall), rgb_of(dark.occupied));
  EXPECT_EQ(picture.pixel(places[0].left - 2, places[0].top), rgb_of(Style{}.page));
  EXPECT_EQ(picture.pixel(places[1].left - 2, places[1].top), rgb_of(dark.page));
}

TEST(Panels, GrowByALegendAndCaptions) {
  const Scene bare{.space = *make_free_space(map_of({"..", ".."}))};
  Scene marked = bare;
  marked.start = centre_of({0, 0});
  const int plain = png_of({{"a", bare}, {"b", bare}}).height();
  EXPECT_EQ(png_of({{"a", bare, "caption"}, {"b", bare}}).height(), plain + 48);
  EXPECT_EQ(png_of({{"a", bare, "a caption\nof three\nlines"}, {"b", bare}}).height(), plain + 70);
  EXPECT_EQ(png_of({{"a", bare}, {"b", marked}}).height(), plain) << "beside the scale bar";
}

TEST(Panels, HaveRoomForALongCaption) {
  const Scene bare{.space = *make_free_space(map_of({"..", ".."}))};
  std::string reason;
  for (int i = 0; i < 30; ++i) reason += "no path ";
  const int line = 22;
  const int shorter = png_of({{"a", bare, "caption"}}).height();
  const int longer = png_of({{"a", bare, reason}}).height();
  EXPECT_GE(longer, shorter + line);
  EXPECT_LE(png_of({{"a", bare, reason + reason + reason + reason + reason}}).height(),
            shorter + 4 * line)
      << "six lines at most";
}

TEST(Panels, CutNoTextHoweverLong) {
  const std::string words(3000, 'w');
  std::string sentence;
  for (int i = 0; i < 300; ++i) sentence += "expanded ";
  Scene scene = heated(5, words);
  for (const std::string& text : {words, sentence, std::string("ä…ß→") + words, std::string()}) {
    const std::vector<Panel> panels{{text, scene, text}};
    const Picture picture = png_of(panels);
    for (int y = 0; y < picture.height(); ++y) {
      ASSERT_EQ(picture.pixel(picture.width() - 3, y), 0xFFFFFFU) << "text in the margin";
    }
  }
}

TEST(Panels, ComeAsSvgAndPdfToo) {
  const std::vector<Panel> panels{{"a", heated(100), "caption"}, {"b", heated(50)}};
  const auto svg = draw_panels(panels, PictureKind::svg);
  ASSERT_TRUE(svg);
  EXPECT_TRUE(well_formed(*svg));
  const auto pdf = draw_panels(panels, PictureKind::pdf);
  ASSERT_TRUE(pdf);
  EXPECT_TRUE(pdf->starts_with("%PDF-1."));
  EXPECT_TRUE(contains(*pdf, "/Count 1"));
  EXPECT_EQ(*pdf, *draw_panels(panels, PictureKind::pdf));
}

}  // namespace
}  // namespace wend
