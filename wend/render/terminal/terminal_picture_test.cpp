#include "wend/render/terminal/terminal_picture.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

Terminal detected(std::vector<const char*> environment) {
  environment.push_back(nullptr);
  return detect_terminal(environment.data());
}

TEST(DetectTerminal, ReadsTheEnvironment) {
  EXPECT_EQ(detected({"TERM=xterm-kitty"}).graphics, TerminalGraphics::kitty);
  EXPECT_EQ(detected({"TERM=mlterm"}).graphics, TerminalGraphics::sixel);
  const Terminal plain = detected({"HOME=/", "TERM=xterm-256color", "COLORTERM=truecolor"});
  EXPECT_EQ(plain.graphics, TerminalGraphics::half_blocks);
  EXPECT_EQ(plain.colours, TerminalColours::true_colour);
  EXPECT_EQ(detected({"TERM=screen"}).colours, TerminalColours::palette_256);
  EXPECT_EQ(detected({"TERM=linux"}).colours, TerminalColours::sixteen);
}

TEST(DetectTerminal, WritesAsciiToADumbTerminalAlone) {
  EXPECT_FALSE(detected({"TERM=dumb"}).unicode);
  EXPECT_FALSE(detected({}).unicode);
  EXPECT_TRUE(detected({"TERM=xterm"}).unicode);
  EXPECT_TRUE(detected({"TERM=xterm", "NO_COLOR=1"}).unicode);
}

TEST(DetectTerminal, TakesAsciiWhereNoColourIsWanted) {
  const std::vector<std::vector<const char*>> environments{
      {}, {"TERM=dumb"}, {"TERM="}, {"TERMINAL=xterm"}, {"TERM=xterm-kitty", "NO_COLOR=1"},
  };
  for (const auto& environment : environments) {
    EXPECT_EQ(detected(environment).graphics, TerminalGraphics::ascii);
    EXPECT_EQ(detected(environment).colours, TerminalColours::none);
  }
  EXPECT_EQ(detected({"TERM=xterm-kitty", "NO_COLOR="}).graphics, TerminalGraphics::kitty);
}

/// A room of 40 x 20 cells with a wall from below, a path over it, in blocks of 2 x 4 cells.
Scene room() {
  Grid<CellState> cells(40, 20);
  for (int y = 4; y < 20; ++y) cells[{20, y}] = CellState::occupied;
  for (int y = 16; y < 20; ++y) {
    for (int x = 0; x < 8; ++x) cells[{x, y}] = CellState::unknown;
  }
  Scene scene{.space = *make_free_space(*make_grid_map(cells))};
  scene.path = Path({{2, 10}, {18, 2}, {22, 2}, {36, 18}});
  scene.start = centre_of({2, 10});
  scene.goals = {centre_of({36, 18})};
  return scene;
}

TEST(TerminalPicture, IsPlainAsciiWithoutColours) {
  EXPECT_EQ(terminal_picture(room(), 20, 10, {}), lines_of({
                                                      ".......ooooo........",
                                                      "...ooooo..#.oo......",
                                                      ".Soo......#..ooo....",
                                                      "..........#....oo...",
                                                      "????......#......oG.",
                                                  }));
}

TEST(TerminalPicture, KeepsThinWallsAndThePathInAFewCharacters) {
  EXPECT_EQ(terminal_picture(room(), 10, 10, {}), lines_of({
                                                      ".oooooo...",
                                                      "So...#ooo.",
                                                      "??...#..oG",
                                                  }));
}

TEST(TerminalPicture, ShowsRolesInAsciiButNotOverWalls) {
  Scene scene{.space = *make_free_space(map_of({"..##", "..##", "....", "...."}))};
  scene.marked = {{CellRole::expanded, marked_of({"****", "****", "....", "...."}, '*')},
                  {CellRole::frontier, marked_of({"....", "....", "+...", "...."}, '+')}};
  scene.narrowest = centre_of({3, 3});
  EXPECT_EQ(terminal_picture(scene, 4, 2, {}), lines_of({"**##", "+..!"}));
}

TEST(TerminalPicture, DrawsHalfBlocksInTwoColours) {
  const Scene scene{.space = *make_free_space(map_of({"#.", ".#", "##", "##"}))};
  const Terminal terminal{TerminalGraphics::half_blocks, TerminalColours::true_colour};
  const std::string picture = terminal_picture(scene, 2, 2, terminal);
  EXPECT_EQ(std::count(picture.begin(), picture.end(), '\n'), 2);
  EXPECT_NE(picture.find("▄"), std::string::npos);
  EXPECT_NE(picture.find("2;43;45;51"), std::string::npos) << "the colour of obstacles";
  EXPECT_NE(picture.find("2;255;255;255"), std::string::npos) << "the colour of free cells";
}

TEST(TerminalPicture, KeepsMarksApartInSixteenColours) {
  Scene scene{.space = *make_free_space(*make_grid_map(Grid<CellState>(1000, 1000)))};
  scene.path = Path({{100, 100}, {100, 900}, {900, 900}});
  scene.start = Point{100, 100};
  scene.goals = {Point{900, 900}};
  const Terminal terminal{TerminalGraphics::half_blocks, TerminalColours::sixteen};
  const std::string picture = terminal_picture(scene, 60, 30, terminal);
  for (const char* background : {"42", "94", "101"}) {
    EXPECT_NE(picture.find(background), std::string::npos) << background;
  }
}

using Pixels = std::vector<std::vector<std::uint32_t>>;

/// What a terminal draws with.
struct Ink {
  std::uint32_t ink = 0;
  std::uint32_t ground = 0;
  bool inverse = false;

  /// Of a true colour's sequence, after "\x1b[", up to its "m".
  void read(std::istringstream& text) {
    std::string sequence;
    std::getline(text, sequence, 'm');
    std::replace(sequence.begin(), sequence.end(), ';', ' ');
    std::istringstream numbers(sequence.substr(1));
    for (unsigned what = 0; numbers >> what;) {
      if (what == 0) *this = {};
      if (what == 7) inverse = true;
      if (what != 38 && what != 48) continue;
      unsigned kind = 0;
      std::uint32_t red = 0;
      std::uint32_t green = 0;
      std::uint32_t blue = 0;
      numbers >> kind >> red >> green >> blue;
      (what == 38 ? ink : ground) = red << 16U | green << 8U | blue;
    }
  }

  std::uint32_t before() const { return inverse ? ground : ink; }
  std::uint32_t behind() const { return inverse ? ink : ground; }
};

/// What a terminal shows of half blocks in true colours.
Pixels pixels_of_blocks(const std::string& picture) {
  Pixels pixels(2);
  std::istringstream text(picture);
  Ink ink;
  const auto put = [&](std::uint32_t upper, std::uint32_t lower) {
    pixels[pixels.size() - 2].push_back(upper);
    pixels.back().push_back(lower);
  };
  for (char byte = 0; text.get(byte);) {
    if (byte == '\x1b') ink.read(text);
    if (byte == '\n') pixels.resize(pixels.size() + 2);
    if (byte == ' ') put(ink.behind(), ink.behind());
    if (byte != '\xE2') continue;
    text.ignore(1);
    text.get(byte);  // the last byte of a half block's three
    byte == '\x84' ? put(ink.behind(), ink.before()) : put(ink.before(), ink.behind());
  }
  pixels.resize(pixels.size() - 2);
  return pixels;
}

const Terminal kBlocks{TerminalGraphics::half_blocks, TerminalColours::true_colour};

RC_GTEST_PROP(TerminalPicture, HidesNoCellBesideAMark, ()) {
  const int width = *rc::gen::inRange(2, 20);
  const int height = *rc::gen::inRange(2, 10);
  Grid<CellState> cells(width, height);
  Scene scene{.space = *make_free_space(*make_grid_map(cells))};
  BitGrid expanded(width, height);
  for (const Cell cell : every_cell(cells)) {
    const int kind = *rc::gen::inRange(0, 3);
    if (kind == 0) cells[cell] = CellState::occupied;
    if (kind == 1) expanded.set(cell, true);
  }
  const auto any_cell = rc::gen::map(
      rc::gen::pair(rc::gen::inRange(0, width), rc::gen::inRange(0, height)),
      [](const std::pair<int, int>& place) { return Cell{place.first, place.second}; });
  const std::vector<Cell> marks{*any_cell, *any_cell, *any_cell};
  scene.space = *make_free_space(*make_grid_map(cells));
  scene.marked = {{CellRole::expanded, expanded}};
  scene.start = centre_of(marks[0]);
  scene.goals = {centre_of(marks[1])};
  scene.narrowest = centre_of(marks[2]);
  const int size = *rc::gen::inRange(1, 7);  // pixels a cell
  const int rows = (size * height + 1) / 2;
  const Pixels pixels = pixels_of_blocks(terminal_picture(scene, size * width, rows, kBlocks));
  const Style style;
  const CellPaints paints(scene, style);
  for (int y = 0; y < size * height; ++y) {
    for (int x = 0; x < size * width; ++x) {
      const Cell cell{x / size, y / size};
      if (std::ranges::find(marks, cell) != marks.end()) continue;
      RC_ASSERT(pixels.at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x)) ==
                rgb_of(paints[cell].colour));
    }
  }
}

TEST(TerminalPicture, KeepsWallsAndMixesNoColoursWhereManyCellsShareAPixel) {
  Scene scene{.space = *make_free_space(map_of({"."}))};
  constexpr int kStep = 160 / test::share_of(160) | 1;  // odd: pixels have cells in pairs
  for (int wall = 0; wall < 160; wall += kStep) {
    Grid<CellState> cells(160, 100);
    for (int y = 0; y < 100; ++y) cells[{wall, y}] = CellState::occupied;
    scene.space = *make_free_space(*make_grid_map(cells));
    for (const Pixels& shown : {pixels_of_blocks(terminal_picture(scene, 48, 40, kBlocks)),
                                pixels_of_blocks(terminal_picture(scene, 80, 40, kBlocks))}) {
      for (const auto& row : shown) {
        EXPECT_EQ(std::ranges::count(row, rgb_of(Style{}.occupied)), 1) << wall;
        EXPECT_GE(std::ranges::count(row, rgb_of(Style{}.free)),
                  static_cast<std::ptrdiff_t>(row.size()) - 1);
      }
    }
  }
}

TEST(TerminalPicture, SpeaksSixelAndKitty) {
  const std::string sixel =
      terminal_picture(room(), 20, 10, {TerminalGraphics::sixel, TerminalColours::true_colour});
  EXPECT_TRUE(sixel.starts_with("\x1bP"));
  EXPECT_TRUE(sixel.ends_with("\x1b\\\n"));
  const std::string kitty =
      terminal_picture(room(), 20, 10, {TerminalGraphics::kitty, TerminalColours::true_colour});
  EXPECT_TRUE(kitty.starts_with("\x1b_G"));
  EXPECT_TRUE(kitty.ends_with("\x1b\\\n"));
}

/// A yard of 8 x 8 cells; a car drives to the right along row 2, and back around a corner and on.
Scene yard() {
  Scene scene{.space = *make_free_space(map_of({
                  "......##",
                  "......##",
                  "......22",
                  "......22",
                  "........",
                  "........",
                  "........",
                  "........",
              }))};
  scene.places = corners_of(scene.space);
  scene.path = Path::through({{0, 2, 0}, {4, 2, 0}, {3, 3, -kPi / 2}, {3, 6, -kPi / 2}});
  scene.start = scene.path.poses().front();
  scene.goals = {Point{8, 8}};
  return scene;
}

TEST(TerminalPicture, TellsAheadFromReverseInAscii) {
  EXPECT_EQ(terminal_picture(yard(), 8, 4, {}), lines_of({
                                                    "......##",
                                                    "Soo==.~~",
                                                    "...=....",
                                                    "...=...G",
                                                }));
}

TEST(TerminalPicture, ColoursAYard) {
  const Terminal terminal{TerminalGraphics::half_blocks, TerminalColours::true_colour};
  const std::string picture = terminal_picture(yard(), 80, 40, terminal);
  for (const Colour& colour : {Style{}.yard_occupied, Style{}.path, Style{}.reverse}) {
    const std::uint32_t rgb = rgb_of(colour);
    const std::string code = fmt::format("2;{};{};{}", rgb >> 16U, rgb >> 8U & 255U, rgb & 255U);
    EXPECT_NE(picture.find(code), std::string::npos) << code;
  }
}

TEST(TerminalShortage, SaysWhereCellsVanishAndWhatWouldHelp) {
  const Scene wide{
      .space = *make_free_space(*make_grid_map(Grid<CellState>(600, 100, CellState::free)))};
  const Terminal ascii;
  const Terminal blocks{TerminalGraphics::half_blocks, TerminalColours::true_colour};
  for (const Terminal& terminal : {ascii, blocks}) {
    EXPECT_EQ(terminal_shortage(wide, 100, 40, terminal),
              "too small: 6 x 12 cells a character; a wider terminal or -o FILE.png shows more");
    EXPECT_EQ(terminal_shortage(wide, 300, 80, terminal), "") << "a wall is still seen";
  }
  const Scene high{
      .space = *make_free_space(*make_grid_map(Grid<CellState>(100, 600, CellState::free)))};
  EXPECT_EQ(terminal_shortage(high, 100, 40, blocks),
            "too small: 8 x 16 cells a character; a higher terminal or -o FILE.png shows more");
  const Terminal pixels{TerminalGraphics::kitty, TerminalColours::true_colour};
  EXPECT_EQ(terminal_shortage(high, 100, 40, pixels), "");
}

TEST(TerminalPicture, ShowsHeatAsDigitsInAscii) {
  Scene scene{.space = *make_free_space(map_of({"...#", "...#"}))};
  scene.heatmap = {"cost", Grid<double>(4, 2)};
  for (int y = 0; y < 2; ++y) {
    scene.heatmap->values[{1, y}] = 55;
    scene.heatmap->values[{2, y}] = 100;
    scene.heatmap->values[{3, y}] = 100;  // a wall
  }
  EXPECT_EQ(terminal_picture(scene, 4, 1, {}), "059#\n");
  EXPECT_EQ(terminal_legend(scene, 80, {}), "0-9 cost, 0 to 100\n");
}

TEST(TerminalLegend, ExplainsTheColoursOfThePicture) {
  Scene scene = room();
  scene.path = {};
  scene.heatmap = {"order of expansion", Grid<double>(40, 20, 7.0)};
  scene.heatmap->values[{3, 3}] = 8321;
  const Terminal terminal{TerminalGraphics::half_blocks, TerminalColours::true_colour};
  const std::string legend = terminal_legend(scene, 200, terminal);
  EXPECT_TRUE(legend.starts_with("order of expansion  7 \x1b[48;2;255;243;191m "));
  EXPECT_NE(legend.find("\x1b[48;2;176;85;154m \x1b[0m 8321"), std::string::npos);
  EXPECT_NE(legend.find("\x1b[48;2;0;158;115m  \x1b[0m start"), std::string::npos);
  EXPECT_NE(legend.find("\x1b[48;2;198;201;206m  \x1b[0m unknown"), std::string::npos);
  EXPECT_EQ(legend.find("path"), std::string::npos);
  EXPECT_EQ(std::ranges::count(legend, '\n'), 1);
  EXPECT_EQ(std::ranges::count(terminal_legend(scene, 60, terminal), '\n'), 2);
}

TEST(TerminalLegend, IsEmptyWhereThereIsNothingToExplain) {
  EXPECT_EQ(terminal_legend({.space = *make_free_space(map_of({".#"}))}, 80, {}), "");
}

RC_GTEST_PROP(TerminalPicture, StaysWithinColumnsAndRows, ()) {
  const int width = *rc::gen::inRange(1, 300);
  const int height = *rc::gen::inRange(1, 300);
  const int columns = *rc::gen::inRange(0, 120);
  const int rows = *rc::gen::inRange(0, 60);
  const auto colours = *rc::gen::element(TerminalColours::none, TerminalColours::true_colour);
  const Scene scene{.space = *make_free_space(*make_grid_map(Grid<CellState>(width, height)))};
  const Terminal terminal{TerminalGraphics::half_blocks, colours};
  std::istringstream lines(terminal_picture(scene, columns, rows, terminal));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    if (colours == TerminalColours::none) {
      RC_ASSERT(static_cast<int>(line.size()) <= std::max(1, columns));
    }
  }
  RC_ASSERT(count >= 1);
  RC_ASSERT(count <= std::max(1, rows));
}

}  // namespace
}  // namespace wend
