#include "wend/render/terminal/text_picture.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "tests/testing/drawn_map.hpp"
#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

constexpr Frame kYUp{.y_up = true};

TEST(TextPicture, ShowsEveryKindOfCell) {
  const FreeSpace space = *make_free_space(map_of({
      "#?1",
      "123",
      "459",
  }));
  EXPECT_EQ(text_picture({.space = space}), lines_of({
                                                "#?.",
                                                ".~3",
                                                "459",
                                            }));
}

TEST(TextPicture, MarksTerrainThatIsNoDigitAsRough) {
  Grid<double> terrain(3, 1, 1);
  terrain[{0, 0}] = 1.5;
  terrain[{1, 0}] = 12;
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(3, 1), {}, terrain));
  EXPECT_EQ(text_picture({.space = space}), "~~.\n");
}

TEST(TextPicture, ShowsWhereTheRobotIsTooClose) {
  const FreeSpace space = *make_free_space(map_of({
                                               ".......",
                                               ".......",
                                               "...#...",
                                               ".......",
                                               ".......",
                                           }),
                                           {.footprint = Footprint::disc(1)});
  EXPECT_EQ(text_picture({.space = space}), lines_of({
                                                ".......",
                                                "..:::..",
                                                "..:#:..",
                                                "..:::..",
                                                ".......",
                                            }));
}

TEST(TextPicture, PointsArrowsAllEightWays) {
  // Around a square by its corners and edges, then away.
  const Path path({{1, 0}, {2, 1}, {2, 2}, {1, 3}, {0, 2}, {0, 1}, {1, 0}});
  const Path straight({{4, 0}, {3, 0}, {3, 1}, {4, 1}, {5, 0}});
  const FreeSpace space = *make_free_space(map_of({
      "......",
      "......",
      "......",
      "......",
  }));
  Scene scene{.space = space};
  scene.path = path;
  EXPECT_EQ(text_picture(scene), lines_of({
                                     ".↘....",
                                     "↗.↓...",
                                     "↑.↙...",
                                     ".↖....",
                                 }));
  scene.path = straight;
  EXPECT_EQ(text_picture(scene), lines_of({
                                     "...↓←.",
                                     "...→↗.",
                                     "......",
                                     "......",
                                 }));
}

TEST(TextPicture, ComesOutAsTheFileLooksWithYUp) {
  const FreeSpace space = *make_free_space(map_of(
      {
          "#..",
          "...",
          "..?",
      },
      kYUp));
  Scene scene{.space = space};
  scene.path = Path({{0, 0}, {1, 1}, {2, 2}});  // from bottom left to top right
  scene.start = centre_of({0, 0});
  scene.goals = {centre_of({2, 2})};
  EXPECT_EQ(text_picture(scene), lines_of({
                                     "#.G",
                                     ".↗.",
                                     "S.?",
                                 }));
}

TEST(TextPicture, DrawsStartAndGoalsOverThePathAndThePathOverExpandedCells) {
  Scene scene{.space = *make_free_space(map_of({"......"}))};
  scene.path = Path({{1, 0}, {2, 0}, {3, 0}, {4, 0}});
  scene.start = Point{1.9, 0.1};
  scene.goals = {centre_of({4, 0}), centre_of({5, 0})};
  scene.marked = {{CellRole::expanded, marked_of({"***..."}, '*')}};
  EXPECT_EQ(text_picture(scene), "*S→→GG\n");
}

TEST(TextPicture, PointsArrowsTheNearestWayInAllCellsThatLinesLeadThrough) {
  Scene scene{.space = *make_free_space(map_of({"......", "......"}))};
  scene.path = Path({{0, 0}, {4, 1}, {5, 1}});
  EXPECT_EQ(text_picture(scene), lines_of({"→→→...", "..→→→→"}));
}

TEST(TextPicture, LeavesOutWhatLiesOutsideTheMap) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Scene scene{.space = *make_free_space(map_of({"..", ".."}))};
  scene.path = Path({{-1, 0}, {0, 0}, {5, 0}});
  scene.start = Point{-0.5, 0.5};
  scene.goals = {Point{0.5, 2}, Point{kInfinity, 0}, Point{kNaN, 0}};
  scene.narrowest = Point{0.5, -1};
  EXPECT_EQ(text_picture(scene), lines_of({"→→", ".."}));
}

TEST(TextPicture, ExplainsOnlyWhatIsInThePicture) {
  Scene scene{.space = *make_free_space(map_of({"..#"}))};
  scene.start = centre_of({0, 0});
  EXPECT_EQ(text_picture(scene, {.legend = true}),
            lines_of({"S.#", "S start   # obstacle   . free"}));
}

TEST(TextPicture, BreaksALegendThatIsTooLong) {
  Scene scene{.space = *make_free_space(map_of({"..#"}))};
  scene.start = centre_of({0, 0});
  EXPECT_EQ(text_picture(scene, {.legend = true, .columns = 20}),
            lines_of({"S.#", "S start   # obstacle", ". free"}));
  EXPECT_EQ(text_picture(scene, {.legend = true, .columns = 19}),
            lines_of({"S.#", "S start", "# obstacle   . free"}));
}

TEST(TextPicture, ShowsRolesAndTheNarrowestPlaceAndExplainsThem) {
  const std::vector<std::string_view> drawn{"**+@#", "s.g!."};
  Scene scene{.space = *make_free_space(map_of(drawn))};
  for (const auto& [role, character] : {std::pair(CellRole::expanded, '*'),
                                        {CellRole::frontier, '+'},
                                        {CellRole::current, '@'},
                                        {CellRole::start_component, 's'},
                                        {CellRole::goal_component, 'g'}}) {
    scene.marked.push_back({role, marked_of(drawn, character)});
  }
  scene.marked.front().cells.set({4, 0}, true);  // the obstacle stays
  scene.narrowest = centre_of({3, 1});
  EXPECT_EQ(text_picture(scene, {.legend = true}),
            lines_of({"**+@#", "s.g!.",
                      "! narrowest   @ being expanded   + frontier   * expanded   "
                      "s start's component   g goal's component   # obstacle   . free"}));
}

TEST(TextPicture, CanDoWithAscii) {
  Scene scene{.space = *make_free_space(map_of({"......", ".....#"}))};
  scene.path = Path({{1, 0}, {2, 0}, {3, 1}, {4, 0}});
  EXPECT_EQ(text_picture(scene, {.legend = true, .ascii = true}),
            lines_of({".>\\...", ".../.#", "> path   # obstacle   . free"}));
}

TEST(TextPicture, ColoursRunsOfCellsOnlyWhenAsked) {
  Scene scene{.space = *make_free_space(map_of({"#....#"}))};
  scene.path = Path({{1, 0}, {2, 0}, {3, 0}});
  scene.start = centre_of({1, 0});
  scene.goals = {centre_of({3, 0})};
  EXPECT_EQ(text_picture(scene), "#S→G.#\n");
  EXPECT_EQ(text_picture(scene, {.colours = true}),
            "#\x1b[1;32mS\x1b[0m\x1b[1;97;44m→\x1b[0m\x1b[1;31mG\x1b[0m\x1b[90m.\x1b[0m#\n");
}

TEST(TextPicture, HeadsWhereACarDoesInTheCellsThatItDrivesThrough) {
  Scene scene{.space = *make_free_space(map_of({".....", ".....", "....."}))};
  scene.path = Path::through({{0.5, 0.5, 0}, {2.5, 0.5, 0}, {4.5, 2.5, kPi / 2}});
  EXPECT_EQ(text_picture(scene), lines_of({"→→→↘.", "...↘↓", "....↓"}));
  scene.path = Path::through({{3.5, 1.5, 0}, {1.5, 1.5, 0}});
  EXPECT_EQ(text_picture(scene), lines_of({".....", ".→→→.", "....."})) << "in reverse";
}

TEST(TextPicture, KnowsWhetherAMapFits) {
  const GridMap map = map_of({"....", "...."});
  EXPECT_TRUE(fits_as_text(map, 4, 2));
  EXPECT_FALSE(fits_as_text(map, 3, 2));
  EXPECT_FALSE(fits_as_text(map, 4, 1));
}

constexpr double kNoNumber = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// Numbers for the cells of a map without any.
Scene numbered(const FreeSpace& space) {
  Scene scene{.space = space};
  scene.heatmap = {"cost", Grid<double>(space.width(), space.height())};
  return scene;
}

TEST(TextArrows, ShowsAPolicyAsDrawn) {
  Scene scene{.space = *make_free_space(map_of({
                  ".#.",
                  "..?",
                  "...",
              }))};
  scene.goals = {centre_of({2, 2})};
  ArrowField policy(3, 3);
  policy[{0, 0}] = Direction::plus_y;
  policy[{1, 0}] = Direction::plus_y;  // the obstacle stays
  policy[{0, 1}] = Direction::plus_x_plus_y;
  policy[{1, 1}] = Direction::plus_y;
  policy[{0, 2}] = Direction::plus_x;
  policy[{1, 2}] = Direction::plus_x;
  scene.arrows = policy;
  EXPECT_EQ(text_arrows(scene), lines_of({
                                    "↓ # .",
                                    "↘ ↓ ?",
                                    "→ → G",
                                }));
}

TEST(TextArrows, DrawsTheLastRowFirstWithYUp) {
  Scene scene{.space = *make_free_space(map_of({"..", ".#"}, {.y_up = true}))};
  ArrowField policy(2, 2);
  policy[{0, 0}] = Direction::plus_y;  // the bottom row
  policy[{0, 1}] = Direction::plus_x_plus_y;
  scene.arrows = policy;
  EXPECT_EQ(text_arrows(scene), lines_of({"↗ .", "↑ #"}));
}

TEST(TextNumbers, AlignsWholeNumbersWithoutDecimals) {
  Scene scene = numbered(*make_free_space(map_of({
      "...",
      ".#.",
  })));
  Grid<double>& costs = scene.heatmap->values;
  costs[{1, 0}] = 1;
  costs[{2, 0}] = 12;
  costs[{0, 1}] = 100;
  costs[{2, 1}] = kNoNumber;
  EXPECT_EQ(text_numbers(scene), lines_of({
                                     "  0   1  12",
                                     "100   #   -",
                                 }));
  EXPECT_EQ(columns_a_number(costs), 4);
}

/// A 3 would be read as a cost of 3.
TEST(TextNumbers, ShowNoDigitsOfTerrain) {
  Scene scene = numbered(test::drawn_space("23#"));
  scene.heatmap->values[{0, 0}] = 7;
  scene.heatmap->values[{1, 0}] = kNotANumber;
  EXPECT_EQ(text_numbers(scene), "7 . #\n");
  scene.arrows = ArrowField(3, 1);
  EXPECT_EQ(text_arrows(scene), ". . #\n");
}

TEST(TextNumbers, ShowTheMapWhereThereIsNone) {
  Scene scene = numbered(*make_free_space(map_of({"#..?.."}), {.footprint = Footprint::disc(1)}));
  Grid<double>& numbers = scene.heatmap->values;
  for (int x = 0; x < 6; ++x) numbers[{x, 0}] = x == 5 ? kNotANumber : kNoNumber;
  EXPECT_EQ(text_numbers(scene), "# : : ? : .\n");
  numbers[{1, 0}] = 0.5;  // a clearance, say
  numbers[{3, 0}] = 2;
  EXPECT_EQ(text_numbers(scene), "  # 0.5   : 2.0   :   .\n");
}

TEST(TextNumbers, ShowsAsManyDecimalsAsAreNeeded) {
  Scene scene = numbered(*make_free_space(map_of({"...."})));
  Grid<double>& costs = scene.heatmap->values;
  costs[{0, 0}] = 1.5;
  costs[{1, 0}] = 0.1 + 0.2;
  costs[{2, 0}] = kNotANumber;
  EXPECT_EQ(text_numbers(scene), "1.5 0.3   . 0.0\n");
  costs[{3, 0}] = 1 + std::numbers::sqrt2;
  EXPECT_EQ(text_numbers(scene), "1.50 0.30    . 2.41\n");
}

TEST(TextNumbers, DrawsTheLastRowFirstWithYUp) {
  Scene scene = numbered(*make_free_space(map_of({".", "."}, {.y_up = true})));
  scene.heatmap->values[{0, 1}] = 7;
  EXPECT_EQ(text_numbers(scene), lines_of({"7", "0"}));
}

TEST(TextNumbers, LieOnTheirHeatInColours) {
  Scene scene = numbered(*make_free_space(map_of({"..#"})));
  scene.heatmap->values[{1, 0}] = 5;
  Style style;
  style.heat_colours.front() = colour_from(0xFFFFFF);
  style.heat_colours.back() = colour_from(0x000000);
  EXPECT_EQ(text_numbers(scene, TerminalColours::true_colour, style),
            "\x1b[48;2;255;255;255m\x1b[38;2;0;0;0m0\x1b[0m"
            "\x1b[48;2;0;0;0m\x1b[38;2;255;255;255m 5\x1b[0m #\n");
  EXPECT_EQ(text_numbers(scene, TerminalColours::palette_256, style),
            "\x1b[48;5;231m\x1b[38;5;16m0\x1b[0m\x1b[48;5;16m\x1b[38;5;231m 5\x1b[0m #\n");
  EXPECT_EQ(text_numbers(scene, TerminalColours::sixteen, style), "0 5 #\n");
}

}  // namespace
}  // namespace wend
