#include "wend/io/map/save_map.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "wend/base/random.hpp"
#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using namespace std::string_literals;
using testing::ElementsAre;
using testing::IsEmpty;

const std::string kHeader = "type octile\nheight 2\nwidth 3\nmap\n";

std::string moving_ai_error(std::string_view text) {
  return error_of(load_as(MapFormat::moving_ai_map, text));
}

std::string cells_in(std::string_view text) {
  const auto loaded = load_as(MapFormat::moving_ai_map, text);
  return loaded ? cells_of(loaded->map) : loaded.error().message;
}

TEST(MovingAiMap, DotGAndSAreFreeAndTheRestIsOccupied) {
  const auto loaded =
      load_as(MapFormat::moving_ai_map, "type octile\nheight 2\nwidth 4\nmap\n.GSW\n@OT.\n");
  ASSERT_TRUE(loaded) << error_of(loaded);
  EXPECT_EQ(cells_of(loaded->map), "...#\n###.\n");
  EXPECT_TRUE(loaded->map.uniform_terrain());
  EXPECT_EQ(loaded->map.frame(), Frame{});
  EXPECT_EQ(loaded->format, MapFormat::moving_ai_map);
  EXPECT_THAT(loaded->notes, IsEmpty());
}

TEST(MovingAiMap, LineEndsMayBeCrlfAndTheLastOneMissing) {
  EXPECT_EQ(cells_in("type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n.@\r\n"), ".#\n");
  EXPECT_EQ(cells_in("type octile\nheight 1\nwidth 2\nmap\n.@"), ".#\n");
}

TEST(MovingAiMap, WidthMayComeFirst) {
  EXPECT_EQ(cells_in("type octile\nwidth 2\nheight 1\nmap\n.@\n"), ".#\n");
}

TEST(MovingAiMap, BlankLinesMayFollow) {
  EXPECT_EQ(cells_in(kHeader + "...\n...\n\n \n"), "...\n...\n");
}

TEST(MovingAiMap, EmittersAreFreeAndNoted) {
  const auto loaded = load_as(MapFormat::moving_ai_map, kHeader + "E..\n..@\n");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(cells_of(loaded->map), "...\n..#\n");
  EXPECT_THAT(loaded->notes, ElementsAre("terrain E (emitter) is read as free"));
}

TEST(MovingAiMap, LowerCaseIsReadAsUpperCaseAndNoted) {
  const auto loaded = load_as(MapFormat::moving_ai_map, kHeader + "gs.\ntow\n");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(cells_of(loaded->map), "...\n###\n");
  EXPECT_THAT(loaded->notes, ElementsAre("lower-case letters are read as upper-case ones"));
}

TEST(MovingAiMap, OtherTypesAreRefusedByName) {
  for (const std::string type : {"tile", "patch", "octile-corner"}) {
    EXPECT_EQ(moving_ai_error("type " + type + "\nheight 1\n"),
              "m:1: map type '" + type + "' is not supported, only 'octile' is");
  }
}

TEST(MovingAiMap, TheTypeComesFirst) {
  EXPECT_EQ(moving_ai_error(""), "m: the first line must be 'type octile', not ''");
  EXPECT_EQ(moving_ai_error("height 2\n"),
            "m:1: the first line must be 'type octile', not 'height 2'");
}

TEST(MovingAiMap, TheHeaderNamesBothSizesOnce) {
  EXPECT_EQ(moving_ai_error("type octile\nheight 2\nmap\n"), "m:3: the header has no line 'width'");
  EXPECT_EQ(moving_ai_error("type octile\nwidth 2\nmap\n"), "m:3: the header has no line 'height'");
  EXPECT_EQ(moving_ai_error("type octile\nheight 2\nwidth 3\n"),
            "m:3: the header has no line 'map'");
  EXPECT_EQ(moving_ai_error("type octile\nheight 2\nheight 2\n"), "m:3: duplicate 'height'");
  EXPECT_EQ(moving_ai_error("type octile\ndepth 2\n"),
            "m:2: unexpected header line 'depth 2': expected 'height', 'width' or 'map'");
}

TEST(MovingAiMap, SizesArePositiveWholeNumbers) {
  const auto with_height = [](const std::string& height) {
    return moving_ai_error("type octile\nheight " + height + "\nwidth 3\nmap\n");
  };
  EXPECT_EQ(with_height("0"), "m:2: height must be positive, not 0");
  EXPECT_EQ(with_height("-5"), "m:2: height must be positive, not -5");
  EXPECT_EQ(with_height("4.0"), "m:2: height '4.0' is not a whole number");
  EXPECT_EQ(with_height("9999999999"), "m:2: height '9999999999' is out of range");
}

TEST(MovingAiMap, SizesWhoseProductOverflowsAreRefused) {
  EXPECT_EQ(moving_ai_error("type octile\nheight 65536\nwidth 65537\nmap\n...\n"),
            "m:4: 65537 x 65536 cells are too many, the limit is 1073741824");
}

TEST(MovingAiMap, RowsAreAsManyAndAsLongAsTheHeaderSays) {
  EXPECT_EQ(moving_ai_error(kHeader + "...\n"),
            "m:5: only 1 of the 2 rows that the header declares");
  EXPECT_EQ(moving_ai_error(kHeader + "...\n..\n"),
            "m:6: row 1 has 2 columns, the header declares 3");
  EXPECT_EQ(moving_ai_error(kHeader + "...\n....\n"),
            "m:6: row 1 has 4 columns, the header declares 3");
  EXPECT_EQ(moving_ai_error(kHeader + "...\n...\n...\n"),
            "m:7: extra row after the 2 rows that the header declares");
  const std::string one_row = "type octile\nheight 1\nwidth 3\nmap\n";
  EXPECT_EQ(moving_ai_error(one_row), "m:4: only 0 of the 1 row that the header declares");
  EXPECT_EQ(moving_ai_error(one_row + "...\n...\n"),
            "m:6: extra row after the 1 row that the header declares");
}

TEST(MovingAiMap, LargeSizesWithoutRowsTakeNoMemory) {
  EXPECT_EQ(moving_ai_error("type octile\nheight 32768\nwidth 32768\nmap\n...\n"),
            "m:5: row 0 has 3 columns, the header declares 32768");
}

TEST(MovingAiMap, UnknownLettersAreNamedWithTheirPlace) {
  EXPECT_EQ(moving_ai_error(kHeader + "...\n.x.\n"),
            "m:6: unknown terrain letter 'x' at row 1 column 1");
  EXPECT_EQ(moving_ai_error(kHeader + "..\0\n...\n"s),
            "m:5: unknown terrain letter 0x00 at row 0 column 2");
}

/// A row is read 64 letters at a time.
TEST(MovingAiMap, EveryLetterMayStandAnywhereInARow) {
  Random random(9);
  for (int width = 1; width < 200; ++width) {
    std::string row;
    std::string cells;
    for (int x = 0; x < width; ++x) {
      constexpr std::string_view kLetters = ".GSE@OTWtg";
      const auto letter = static_cast<std::size_t>(random.below(kLetters.size()));
      row += random.chance(0.8) ? '.' : kLetters[letter];
      cells += std::string_view(".GSEg").find(row.back()) != std::string_view::npos ? '.' : '#';
    }
    const std::string header = "type octile\nheight 1\nwidth " + std::to_string(width) + "\nmap\n";
    ASSERT_EQ(cells_in(header + row + "\n"), cells + "\n");
    const auto wrong = static_cast<std::size_t>(random.below(row.size()));
    row[wrong] = 'x';
    ASSERT_EQ(moving_ai_error(header + row),
              "m:5: unknown terrain letter 'x' at row 0 column " + std::to_string(wrong));
  }
}

TEST(MovingAiMap, WhatItCannotHoldIsAnError) {
  Grid<CellState> cells(2, 1);
  cells[{1, 0}] = CellState::unknown;
  const auto error = [](const GridMap& map) {
    return error_of(encode_map(map, MapFormat::moving_ai_map));
  };
  EXPECT_EQ(error(*make_grid_map(cells)),
            "a MovingAI map cannot hold unknown cells (1 cell); a ROS map.yaml, a text grid or an "
            "image can");
  EXPECT_EQ(error(*make_grid_map(Grid<CellState>(2, 1), {}, Grid<double>(2, 1, 3))),
            "a MovingAI map cannot hold terrain; a ROS map.yaml or a text grid can");
}

TEST(MovingAiMap, AMapWithYUpIsWrittenAsItIsDrawn) {
  Grid<CellState> cells(2, 2);
  cells[{0, 0}] = CellState::occupied;
  Frame frame;
  frame.y_up = true;
  EXPECT_EQ(encode_map(*make_grid_map(cells, frame), MapFormat::moving_ai_map)->bytes,
            "type octile\nheight 2\nwidth 2\nmap\n..\n@.\n");
}

RC_GTEST_PROP(MovingAiMap, WrittenMapsReadBack, ()) {
  Grid<CellState> cells(*rc::gen::inRange(1, 80), *rc::gen::inRange(1, 20));
  for (int y = 0; y < cells.height(); ++y) {
    for (CellState& cell : cells.row(y)) {
      cell = *rc::gen::element(CellState::free, CellState::occupied);
    }
  }
  const auto files = encode_map(*make_grid_map(cells), MapFormat::moving_ai_map);
  RC_ASSERT(files.has_value());
  RC_ASSERT(cells_in(files->bytes) == cells_of(*make_grid_map(cells)));
}

}  // namespace
}  // namespace wend
