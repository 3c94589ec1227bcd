#include "wend/path/exact_ends.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/testing/drawn_map.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;

FreeSpace space_of(const char* drawing, double radius = 0) {
  return *make_free_space(test::drawn_map(drawing), {.footprint = Footprint::disc(radius)});
}

TEST(ExactEnds, LeaveAPathBetweenCentresAsItIs) {
  const Path path({{0, 0}, {1, 0}, {2, 0}});
  EXPECT_EQ(with_ends(path, {{0.5, 0.5}, {2.5, 0.5}}, space_of("...\n")), path);
}

TEST(ExactEnds, TakeThePlaceOfTheCentres) {
  const Path path({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  const Path exact = with_ends(path, {{0.9, 0.2}, {3.1, 0.8}}, space_of("....\n"));
  EXPECT_THAT(exact.waypoints(),
              ElementsAre(Point{0.9, 0.2}, Point{1.5, 0.5}, Point{2.5, 0.5}, Point{3.1, 0.8}));
  EXPECT_TRUE(exact.leads_over_cells());
  EXPECT_THAT(exact.passed_cells(), ElementsAreArray(path.cells()));
}

TEST(ExactEnds, GoByWayOfTheCentreWhereTheStraightLineIsBlocked) {
  const FreeSpace space = space_of(
      ".#..\n"
      "....\n"
      ".#..\n",
      0.4);
  const Path path({{0, 1}, {3, 1}});
  const Path exact = with_ends(path, {{0.3, 1.7}, {3.5, 1.5}}, space);
  EXPECT_THAT(exact.waypoints(), ElementsAre(Point{0.3, 1.7}, Point{0.5, 1.5}, Point{3.5, 1.5}));
}

TEST(ExactEnds, JoinTwoPointsOfOneCell) {
  const Path exact = with_ends(Path({{1, 0}}), {{1.1, 0.5}, {1.9, 0.6}}, space_of("...\n"));
  EXPECT_THAT(exact.waypoints(), ElementsAre(Point{1.1, 0.5}, Point{1.9, 0.6}));
}

TEST(ExactEnds, StayAtTheCentreWhereTheRobotDoesNotFit) {
  const FreeSpace space = space_of(
      "#####\n"
      ".....\n"
      "#####\n",
      0.5);
  const Path path({{1, 1}, {2, 1}, {3, 1}});
  const Path exact = with_ends(path, {{1.5, 1.9}, {3.2, 1.5}}, space);
  EXPECT_THAT(exact.waypoints(), ElementsAre(Point{1.5, 1.5}, Point{2.5, 1.5}, Point{3.2, 1.5}));
}

}  // namespace
}  // namespace wend
