#include "wend/render/terminal/text_picture.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "wend/geometry/compass.hpp"
#include "wend/render/car_scene_test.hpp"
#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

/// A car drives around a corner, and back around two others into a gap.
Scene parking(bool y_up) {
  using enum CarMove;
  const Frame frame{.y_up = y_up};
  std::vector<CarMove> moves{fwd, fwd_plus, fwd, rev_minus, rev, rev_minus};
  for (CarMove& move : moves) move = move_on_page(move, frame);
  Scene scene = car_on(*make_free_space(map_of(
                           {
                               "......",
                               "5...2.",
                               "...#.9",
                           },
                           frame)),
                       driven({{0, y_up ? 3 : 0}, Heading::plus_x}, moves));
  scene.start = scene.path.poses().front();
  scene.goals = {scene.path.poses().back()};
  return scene;
}

TEST(LatticePicture, DrawsCornersCellsAndTheWayBetweenThem) {
  EXPECT_EQ(text_picture(parking(false), {.legend = true, .columns = 60}),
            lines_of({
                "  0   1   2   3   4   5   6",
                "0 S→──→──╮·   ·   ·   ·   ·",
                "         ╰╮",
                "1 ·   ·   ↓╔══←═══←══╗·   ·",
                "   ▓▓▓    ╠╝       ░░╚↑",
                "2 ·   ·   ↓   ▗▄▄▄▖   G   ·",
                "              ▐███▌    ▓▓▓",
                "3 ·   ·   ·   ▝▀▀▀▘   ·   ·",
                "S start   G goal   → pose   ─ driven ahead   ═ in reverse",
                "█ obstacle   ░▒▓ rough road   · corner",
            }));
}

TEST(LatticePicture, HasRowZeroBelowWhereYIsUp) {
  EXPECT_EQ(text_picture(parking(true)), lines_of({
                                             "3 S→──→──╮·   ·   ·   ·   ·",
                                             "         ╰╮",
                                             "2 ·   ·   ↓╔══←═══←══╗·   ·",
                                             "   ▓▓▓    ╠╝       ░░╚↑",
                                             "1 ·   ·   ↓   ▗▄▄▄▖   G   ·",
                                             "              ▐███▌    ▓▓▓",
                                             "0 ·   ·   ·   ▝▀▀▀▘   ·   ·",
                                             "  0   1   2   3   4   5   6",
                                         }));
}

TEST(LatticePicture, CanDoWithAscii) {
  EXPECT_EQ(text_picture(parking(false), {.legend = true, .columns = 60, .ascii = true}),
            lines_of({
                "  0   1   2   3   4   5   6",
                "0 S>-->-- .   .   .   .   .",
                "         \\",
                "1 .   .   v ==<===<== .   .",
                "   555    |=       ~~=^",
                "2 .   .   v   #####   G   .",
                "              #####    999",
                "3 .   .   .   #####   .   .",
                "S start   G goal   > pose   - driven ahead   = in reverse",
                "# obstacle   ~ 3-9 rough road   . corner",
            }));
}

TEST(LatticePicture, HasNarrowerCellsWhereThereIsLessRoom) {
  EXPECT_EQ(text_picture(parking(false), {.columns = 28}).substr(0, 30),
            "  0   1   2   3   4   5   6\n0 ");
  EXPECT_EQ(text_picture(parking(false), {.columns = 27}), lines_of({
                                                               "  0  1  2  3  4  5  6",
                                                               "0 S→─→─╮·  ·  ·  ·  ·",
                                                               "       ╰╮",
                                                               "1 ·  ·  ↓╔═←══←═╗·  ·",
                                                               "   ▓▓   ╠╝     ░╚↑",
                                                               "2 ·  ·  ↓  ▗▄▄▖  G  ·",
                                                               "           ▐██▌   ▓▓",
                                                               "3 ·  ·  ·  ▝▀▀▘  ·  ·",
                                                           }));
  EXPECT_EQ(text_picture(parking(false), {.columns = 1}), lines_of({
                                                              "  0 1 2 3 4 5 6",
                                                              "0 S→→╮· · · · ·",
                                                              "     ╰╮",
                                                              "1 · · ↓╔←═←╗· ·",
                                                              "   ▓  ╠╝   ╚↑",
                                                              "2 · · ↓ ▗▄▖ G ·",
                                                              "        ▐█▌  ▓",
                                                              "3 · · · ▝▀▘ · ·",
                                                          }));
}

TEST(LatticePicture, JoinsObstaclesAndShadesRoughRoadsTheMoreTheRougher) {
  EXPECT_EQ(
      text_picture(car_on(*make_free_space(map_of({"#.234", ".##59", "?....", "....."})), {})),
      lines_of({
          "  0   1   2   3   4   5",
          "0 ▗▄▄▄▖   ·   ·   ·   ·",
          "  ▐███▌    ░░░ ▒▒▒ ▒▒▒",
          "1 ▝▀▀▀▚▄▄▄▄▄▄▄▖   ·   ·",
          "      ▐███████▌▓▓▓ ▓▓▓",
          "2 ·   ▝▀▀▀▀▀▀▀▘   ·   ·",
          "   ???",
          "3 ·   ·   ·   ·   ·   ·",
          "",
          "4 ·   ·   ·   ·   ·   ·",
      }));
}

TEST(LatticePicture, ShowsRolesTooCloseCellsAndTheNarrowestPlace) {
  Scene scene = car_on(
      *make_free_space(map_of({"....", "....", "...#"}), {.footprint = Footprint::disc(1)}), {});
  scene.marked = {{CellRole::expanded, marked_of({"*...", "....", "...*"}, '*')}};
  scene.narrowest = Point{1, 2};
  EXPECT_EQ(text_picture(scene, {.legend = true, .columns = 50}),
            lines_of({
                "  0   1   2   3   4",
                "0 ·   ·   ·   ·   ·",
                "   ***",
                "1 ·   ·   ·   ·   ·",
                "           ::: :::",
                "2 ·   !   ·   ▗▄▄▄▖",
                "           :::▐███▌",
                "3 ·   ·   ·   ▝▀▀▀▘",
                "! narrowest   * expanded   █ obstacle",
                ": too close for the robot   · corner",
            }));
}

TEST(LatticePicture, MayShowOnePoseOrNoPath) {
  const FreeSpace space = *make_free_space(map_of({".."}));
  EXPECT_EQ(text_picture(car_on(space, driven({{1, 1}, Heading::minus_x}, {}))),
            lines_of({"  0   1   2", "0 ·   ·   ·", "", "1 ·   ←   ·"}));
  EXPECT_EQ(text_picture(car_on(space, {})),
            lines_of({"  0   1   2", "0 ·   ·   ·", "", "1 ·   ·   ·"}));
}

TEST(LatticePicture, MakesRoomForHeadingsAtTheEdges) {
  Scene scene = car_on(*make_free_space(map_of({".."})), {});
  scene.start = Pose{1, 0, -kPi / 2};
  scene.goals = {Pose{2, 1, 0}, Pose{0, 0, kPi}, Pose{1, 1, kPi / 2}, Point{2, 0}};
  EXPECT_EQ(text_picture(scene), lines_of({
                                     "  0   1   2",
                                     "      ↑",
                                     "0←G   S   G",
                                     "",
                                     "1 ·   G   G→",
                                     "      ↓",
                                 }));
}

TEST(LatticePicture, LeavesOutWhatLiesOutside) {
  Scene scene =
      car_on(*make_free_space(map_of({"..", ".."})),
             Path::through({{1, 1, 0}, {9, 1, 0}, {10, 0, -kPi / 2}, {10, -1e7, -kPi / 2}}));
  scene.start = Pose{-3, 1, 0};
  scene.goals = {Pose{1, 7, 0}};
  scene.narrowest = Point{2, 3};
  EXPECT_EQ(text_picture(scene), lines_of({
                                     "  0   1   2",
                                     "0 ·   ·   ·",
                                     "",
                                     "1 ·   →────",
                                     "",
                                     "2 ·   ·   ·",
                                 }));
}

TEST(LatticePicture, DrawsTheCellsOfALargerUnit) {
  Scene scene = car_on(*make_free_space(map_of({
                           "....9",
                           "...#9",
                           "22..9",
                           "....9",
                           "99999",
                       })),
                       driven({{0, 4}, Heading::minus_y}, {CarMove::fwd_plus}, 2));
  scene.places = corners_of(scene.space, 2);
  EXPECT_EQ(text_picture(scene), lines_of({
                                     "  0   2   4",
                                     "0 ·   ▗▄▄▄▖",
                                     "      ▐███▌",
                                     "2 ·╭──→▀▀▀▘",
                                     "  ╭╯░░",
                                     "4 ↑   ·   ·",
                                 }));
}

TEST(LatticePicture, ColoursCharactersByWhatTheyMean) {
  Scene scene =
      car_on(*make_free_space(map_of({"#.."})), Path::through({{3, 0, 0}, {2, 1, -kPi / 2}}));
  const std::string text = text_picture(scene, {.colours = true});
  EXPECT_NE(text.find("\x1b[31m▐███▌\x1b[0m"), std::string::npos) << text;
  EXPECT_NE(text.find("\x1b[1;94m→\x1b[0m"), std::string::npos) << text;
  EXPECT_NE(text.find("\x1b[1m"), std::string::npos) << "in reverse";
}

TEST(LatticePicture, KnowsWhetherItFits) {
  const Scene scene = parking(false);
  EXPECT_TRUE(fits_as_text(scene, 16, 8));
  EXPECT_FALSE(fits_as_text(scene, 15, 8));
  EXPECT_FALSE(fits_as_text(scene, 16, 7));
}

}  // namespace
}  // namespace wend
