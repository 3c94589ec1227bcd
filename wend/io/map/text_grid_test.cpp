#include "wend/io/map/save_map.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using namespace std::string_literals;

std::string text_grid_error(std::string_view text) {
  return error_of(load_as(MapFormat::text_grid, text));
}

std::string text_grid_cells(std::string_view text) {
  const auto loaded = load_as(MapFormat::text_grid, text);
  return loaded ? cells_of(loaded->map) : loaded.error().message;
}

TEST(TextGrid, EveryLetterHasItsMeaning) {
  const auto loaded = load_as(MapFormat::text_grid, "0.1#@?\n~23589\n");
  ASSERT_TRUE(loaded) << error_of(loaded);
  EXPECT_EQ(cells_of(loaded->map), "..###?\n......\n");
  const std::vector<double> terrain = {1, 1, 1, 1, 1, 1, 2, 2, 3, 5, 8, 9};
  EXPECT_THAT(loaded->map.terrain().values(), testing::ElementsAreArray(terrain));
  EXPECT_EQ(loaded->format, MapFormat::text_grid);
  EXPECT_EQ(loaded->map.frame(), Frame{});
}

TEST(TextGrid, AMapWithoutCostsIsUniform) {
  EXPECT_TRUE(load_as(MapFormat::text_grid, "01\n10\n")->map.uniform_terrain());
}

TEST(TextGrid, BlanksBetweenCellsDoNotMatter) {
  EXPECT_EQ(text_grid_cells("0 1 0\n 0\t0 1 \n000\n"), ".#.\n..#\n...\n");
}

TEST(TextGrid, LineEndsMayBeCrlfAndTheLastOneMissing) {
  EXPECT_EQ(text_grid_cells("01\r\n10\r\n"), ".#\n#.\n");
  EXPECT_EQ(text_grid_cells("01\n10"), ".#\n#.\n");
}

TEST(TextGrid, BlankLinesMayFollow) { EXPECT_EQ(text_grid_cells("01\n10\n\n \t\n"), ".#\n#.\n"); }

TEST(TextGrid, BlankLinesMayNotStandBeforeOrBetweenRows) {
  EXPECT_EQ(text_grid_error("01\n\n10\n"), "m:2: blank line before a row of cells");
  EXPECT_EQ(text_grid_error("\n01\n"), "m:1: blank line before a row of cells");
}

TEST(TextGrid, RowsAreEquallyLong) {
  EXPECT_EQ(text_grid_error("000\n0 0\n"), "m:2: expected 3 cells as in the first row, not 2");
  EXPECT_EQ(text_grid_error("00\n000\n"), "m:2: expected 2 cells as in the first row, not 3");
}

TEST(TextGrid, UnknownLettersAreNamedWithTheirPlace) {
  EXPECT_EQ(text_grid_error("00\n0x\n"), "m:2: unknown letter 'x' in column 2");
  EXPECT_EQ(text_grid_error("0\0\n"s), "m:1: unknown letter 0x00 in column 2");
  EXPECT_EQ(text_grid_error("0 \xE2\x96\x88\n"), "m:1: unknown letter 0xE2 in column 3");
}

TEST(TextGrid, AnEmptyFileIsAnError) {
  EXPECT_EQ(text_grid_error(""), "m: the text grid has no cells");
  EXPECT_EQ(text_grid_error("\n \n"), "m: the text grid has no cells");
}

TEST(TextGrid, WhatItCannotHoldIsAnError) {
  const auto with_terrain = [](CellState state, double terrain) {
    const Grid<CellState> cells(1, 1, state);
    return encode_map(*make_grid_map(cells, {}, Grid<double>(1, 1, terrain)), MapFormat::text_grid);
  };
  EXPECT_EQ(with_terrain(CellState::free, 9)->bytes, "9\n");
  EXPECT_EQ(error_of(with_terrain(CellState::free, 1.5)),
            "a text grid cannot hold the terrain 1.5 of cell (0,0), only whole numbers up to 9 "
            "for free cells");
  EXPECT_FALSE(with_terrain(CellState::free, 10));
  EXPECT_FALSE(with_terrain(CellState::unknown, 2));
}

RC_GTEST_PROP(TextGrid, WrittenMapsReadBack, ()) {
  Grid<CellState> cells(*rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20));
  Grid<double> terrain(cells.width(), cells.height(), 1);
  for (int y = 0; y < cells.height(); ++y) {
    for (std::size_t x = 0; x < cells.row(y).size(); ++x) {
      CellState& state = cells.row(y)[x];
      state = *rc::gen::element(CellState::free, CellState::occupied, CellState::unknown);
      if (state == CellState::free) terrain.row(y)[x] = *rc::gen::inRange(1, 10);
    }
  }
  const GridMap map = *make_grid_map(cells, {}, terrain);
  const auto files = encode_map(map, MapFormat::text_grid);
  RC_ASSERT(files.has_value());
  const auto loaded = load_as(MapFormat::text_grid, files->bytes);
  RC_ASSERT(loaded.has_value());
  RC_ASSERT(cells_of(loaded->map) == cells_of(map));
  RC_ASSERT(loaded->map.terrain() == map.terrain());
}

}  // namespace
}  // namespace wend
