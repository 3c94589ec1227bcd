#include "wend/render/animation/film_canvas.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

Scene filmed_scene(Cell expanded) {
  Scene scene{.space = *make_free_space(map_of({"..#..", "..#..", "....."}))};
  BitGrid cells(5, 3);
  cells.set(expanded, true);
  scene.marked = {{CellRole::expanded, cells}};
  scene.start = centre_of({0, 0});
  return scene;
}

std::ptrdiff_t count_of(const Grid<std::uint32_t>& pixels, const Colour& colour) {
  return std::ranges::count(pixels.values(), rgb_of(colour));
}

TEST(FilmCanvas, ShowsTheMapItsNameACounterAndTheLegend) {
  const std::vector<FilmPanel> panels{{"astar", "1 expanded", filmed_scene({1, 1})}};
  const Style style;
  FilmCanvas canvas(panels, legend_of(panels[0].scene, style), 400, 300, style);
  const Grid<std::uint32_t> pixels = canvas.draw(panels);
  EXPECT_LE(pixels.width(), 400);
  EXPECT_LE(pixels.height(), 300);
  EXPECT_GT(count_of(pixels, style.expanded), 1000) << "the cell, and the legend's square";
  EXPECT_GT(count_of(pixels, style.ink), 200) << "words";
  std::vector<FilmPanel> counted = panels;
  counted[0].counter = "2 expanded";
  const Grid<std::uint32_t> next = canvas.draw(counted);
  EXPECT_NE(pixels, next);
  for (int y = 40; y < pixels.height(); ++y) {
    EXPECT_TRUE(std::ranges::equal(pixels.row(y), next.row(y))) << "below the words, row " << y;
  }
}

TEST(FilmCanvas, DrawsAFrameAsIfItWereTheFirst) {
  const Style style;
  const std::vector<FilmPanel> first{{"bfs", "1 expanded", filmed_scene({1, 1})}};
  const std::vector<FilmPanel> second{{"bfs", "1 expanded", filmed_scene({4, 2})}};
  const auto legend = legend_of(first[0].scene, style);
  FilmCanvas used(first, legend, 300, 300, style);
  FilmCanvas fresh(first, legend, 300, 300, style);
  used.draw(first);
  EXPECT_EQ(used.draw(second), fresh.draw(second));
}

TEST(FilmCanvas, PutsSeveralMapsBesideEachOther) {
  const Style style;
  for (const std::size_t count : {1U, 2U, 6U, 14U}) {
    const std::vector<FilmPanel> panels(count, {"a planner", "9 expanded", filmed_scene({1, 1})});
    FilmCanvas canvas(panels, legend_of(panels[0].scene, style), 1200, 900, style);
    const Grid<std::uint32_t> pixels = canvas.draw(panels);
    EXPECT_LE(pixels.width(), 1200);
    EXPECT_LE(pixels.height(), 900);
    EXPECT_GE(count_of(pixels, style.expanded), static_cast<std::ptrdiff_t>(count) * 200);
  }
}

}  // namespace
}  // namespace wend
