#include "wend/render/terminal/terminal_picture.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

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
  scene.unit = 1;
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
