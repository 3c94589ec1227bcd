#include "wend/render/picture/drawn_cells.hpp"

#include <gtest/gtest.h>

#include "wend/render/picture/drawing.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/png_picture_test.hpp"
#include "wend/render/terminal/terminal_picture.hpp"

namespace wend {
namespace {

constexpr int kSide = 2000;  // cells: four share a pixel, and more in a terminal

Scene expanded_at(const std::vector<Cell>& cells) {
  Scene scene{.space =
                  *make_free_space(*make_grid_map(Grid<CellState>(kSide, kSide, CellState::free)))};
  BitGrid marked(kSide, kSide);
  for (const Cell cell : cells) marked.set(cell, true);
  scene.marked = {{CellRole::expanded, marked}};
  return scene;
}

TEST(SparseCells, AreDotsThatAreSeen) {
  const std::vector<Cell> cells{{300, 400}, {1000, 20}, {1700, 1999}};
  const Scene scene = expanded_at(cells);
  const Picture picture(*draw_png(scene));
  const MapView view = picture_layout(scene.space.map()).view;
  for (const Cell cell : cells) {
    const Point centre = view.to_picture(centre_of(cell));
    EXPECT_EQ(picture.pixel(centre.x, centre.y), rgb_of(Style{}.expanded));
    EXPECT_EQ(picture.pixel(centre.x + 2, centre.y), rgb_of(Style{}.expanded));
    EXPECT_EQ(picture.pixel(centre.x + 20, centre.y), rgb_of(Style{}.free));
  }
}

TEST(SparseCells, AreSeenInTheTerminal) {
  const Terminal terminal{TerminalGraphics::half_blocks, TerminalColours::true_colour};
  const std::string with = terminal_picture(expanded_at({{300, 400}}), 80, 24, terminal);
  EXPECT_NE(with, terminal_picture(expanded_at({}), 80, 24, terminal));
}

TEST(SparseCells, AreAloneAndExpanded) {
  MarkedCells marked{CellRole::expanded, BitGrid(100, 100)};
  EXPECT_TRUE(sparse_cells(marked, 4, 9).empty());
  marked.cells.set({0, 4}, true);
  marked.cells.set({2, 5}, true);
  EXPECT_EQ(sparse_cells(marked, 4, 9), std::vector<Cell>({{0, 4}, {2, 5}}));
  EXPECT_TRUE(sparse_cells(marked, 9, 9).empty()) << "cells are as large as dots";
  marked.cells.set({3, 6}, true);
  EXPECT_EQ(sparse_cells(marked, 4, 9), std::vector<Cell>({{0, 4}})) << "an area is seen";
  marked.role = CellRole::frontier;
  EXPECT_TRUE(sparse_cells(marked, 4, 9).empty());
}

TEST(SparseCells, AreNoneWhereTheyWouldHideTheMap) {
  MarkedCells marked{CellRole::expanded, BitGrid(100, 100)};
  for (int y = 0; y < 100; y += 4) {
    for (int x = 0; x < 100; x += 4) marked.cells.set({x, y}, true);
  }
  EXPECT_TRUE(sparse_cells(marked, 4, 9).empty());
}

}  // namespace
}  // namespace wend
