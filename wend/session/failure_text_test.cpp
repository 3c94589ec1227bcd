// Why a robot with headings finds no drive, sentence by sentence.

#include "wend/session/failure_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/testing/drawn_map.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using ::testing::HasSubstr;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

FreeSpace space_for(std::string_view drawing, std::string_view footprint) {
  return test::drawn_space(
      drawing, {.footprint = *parse_footprint(footprint), .outside = OutsidePolicy::blocked});
}

/// "goal_blocked: the robot ..."; "found" for a query with a path.
std::string answer(const FreeSpace& space, const Query& query, const OptionValues& options = {}) {
  const auto planner = make_planner("hybrid_astar", space, options);
  if (!planner) return planner.error().message;
  const auto plan = (*planner)->plan(query);
  if (plan) return "found";
  const Status status = plan.error().status;
  return std::string(to_string(status)) + ": " + words_of(plan.error(), space);
}

Query between(Pose start, Pose goal) { return {start, {Goal(goal)}}; }

const OptionValues kTight{{"turning_radius", "2"}, {"time_budget", "100"}};
constexpr std::string_view kBox = "1.4,0.9; 1.4,-0.9; -1.4,-0.9; -1.4,0.9";

/// What has been searched.
const std::string kFinely =
    "in boxes of 0.25 cells, 72 headings and motions of 0.5 cells; a search on a lattice of half "
    "cells and 16 headings found none either; there may be one all the same";

constexpr std::string_view kYard =
    "..............\n"
    "..............\n"
    "..............\n"
    "......#.......\n"
    "..............\n"
    "..............\n"
    "..............\n";

TEST(FailureText, NameTheCornerThatTouches) {
  const FreeSpace yard = space_for(kYard, kBox);
  EXPECT_EQ(answer(yard, between({5, 2.5, 0}, {12, 2, 0}), kTight),
            "start_blocked: the start (5,2.5,E) is blocked: the robot's front right "
            "corner lies in the obstacle cell (6,3)");
  EXPECT_EQ(answer(yard, between({2, 2.5, 0}, {13, 2, 0}), kTight),
            "goal_blocked: the goal (13,2,E) is blocked: the robot's front right corner "
            "reaches over the map's edge");
  EXPECT_EQ(answer(yard, between({2, 2.5, 0}, {6.5, 3.5, kPi / 2}), kTight),
            "goal_blocked: the goal (6.5,3.5,S) is blocked: cell (6,3) is an obstacle");
}

/// Motions of the lattice reach too far for such a radius, so there is none.
TEST(FailureText, NameTheLatticeOnlyIfItWasSearched) {
  const FreeSpace yard = space_for(kYard, kBox);
  const std::string text =
      answer(yard, between({3, 2, 0}, {3, 5, kPi}), {{"turning_radius", "100000"}});
  EXPECT_TRUE(text.starts_with("unreachable: ")) << text;
  EXPECT_EQ(text.find("lattice"), std::string::npos) << text;
}

TEST(FailureText, NameTheDistanceThatADiscLacks) {
  const FreeSpace yard = space_for(kYard, "disc:1.5");
  EXPECT_EQ(answer(yard, between({5.5, 3.5, 0}, {12, 3, 0}), kTight),
            "start_blocked: the start (5.5,3.5,E) is blocked: the nearest obstacle is 0.5 cells "
            "away, the robot's radius is 1.5 cells");
}

TEST(FailureText, SayWhatIsKnownOfAGoalWithAnyHeading) {
  const FreeSpace yard = space_for(kYard, kBox);
  const Query query{{2, 2.5, 0}, {Goal(Point{6.5, 3.5})}};
  EXPECT_EQ(answer(yard, query, kTight),
            "goal_blocked: the goal (6.5,3.5,any) is blocked at every heading that was tried; at "
            "E: cell (6,3) is an obstacle");
}

TEST(FailureText, CompareARobotThatIsLargerThanTheMapWithIt) {
  const FreeSpace lorry = space_for(kYard, "12,3; 12,-3; -12,-3; -12,3");
  EXPECT_EQ(answer(lorry, between({7, 3.5, 0}, {8, 3.5, 0}), kTight),
            "start_blocked: the robot's footprint, 24 x 6 cells, is larger than the map, 14 x 7 "
            "cells");
  const FreeSpace disc = space_for(kYard, "disc:4");
  EXPECT_EQ(answer(disc, between({3, 3.5, 0}, {8, 3.5, 0}), kTight),
            "start_blocked: the robot, a disc with a radius of 4 cells, is larger than the map, "
            "14 x 7 cells");
}

TEST(FailureText, RefuseHeadingsThatAreNotNumbers) {
  const FreeSpace yard = space_for(kYard, kBox);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(answer(yard, between({3, 3, nan}, {12, 3, 0}), kTight),
            "unsupported_query: the heading of the start is not a number of radians in -1e6..1e6");
  EXPECT_EQ(answer(yard, between({3, 3, 0}, {12, 3, nan}), kTight),
            "unsupported_query: the heading of the goal is not a number of radians in -1e6..1e6");
}

TEST(FailureText, RefuseACarWithoutATurningRadius) {
  const FreeSpace yard = space_for(kYard, kBox);
  const auto planner = make_planner("hybrid_astar", yard, {{"turning_radius", "0"}});
  ASSERT_FALSE(planner);
  EXPECT_EQ(planner.error().message,
            "a car needs a turning_radius greater than 0; a robot that turns in place has "
            "motion_model=differential");
  EXPECT_EQ(planner.error().where, "turning_radius");
  EXPECT_TRUE(make_planner("hybrid_astar", yard,
                           {{"turning_radius", "0"}, {"motion_model", "differential"}}));
}

TEST(FailureText, SayWhatThePartsOfTheMapCover) {
  const FreeSpace yard = space_for(kYard, kBox);
  EXPECT_EQ(answer(yard, between({3, 3, 0}, {30, 3, 0}), kTight),
            "goal_outside: the goal (30,3), cell (30,3) is outside the map, which covers the "
            "cells with x from 0 to 13 and y from 0 to 6");
  EXPECT_EQ(answer(yard, between({-3, 3, 0}, {3, 3, 0}), kTight),
            "start_outside: the start (-3,3), cell (-3,3) is outside the map, which covers the "
            "cells with x from 0 to 13 and y from 0 to 6");
}

TEST(FailureText, TellPlacesThatNoDiscJoins) {
  const FreeSpace parted = space_for(
      "......#......\n"
      "......#......\n"
      "......#......\n"
      ".............\n"
      "......#......\n"
      "......#......\n"
      "......#......\n",
      "1.4,1.3; 1.4,-1.3; -1.4,-1.3; -1.4,1.3");
  EXPECT_EQ(
      answer(parted, between({3, 3.5, 0}, {10, 3.5, 0}), kTight),
      "unreachable: there is no path from start (3,3.5,E) to goal (10,3.5,E): obstacles "
      "separate the two, even for the largest disc within the robot, with a radius of 1.3 cells");
}

/// A room for the robot beside a wide one. The wall between them has a gap that is wide enough for its disc, but the
/// room is too narrow to turn into it.
constexpr std::string_view kSlot =
    "....................\n"
    "....................\n"
    "....................\n"
    "....................\n"
    "....................\n"
    "....................\n"
    "....................\n"
    "######..############\n"
    "####......##########\n"
    "####......##########\n"
    "####################\n";

TEST(FailureText, TellAGoalThatIsBoxedIn) {
  const FreeSpace slot = space_for(kSlot, "2.9,0.8; 2.9,-0.8; -2.9,-0.8; -2.9,0.8");
  EXPECT_EQ(answer(slot, between({4, 3.5, 0}, {7, 9, 0}), kTight),
            "unreachable: the goal (7,9,E) is boxed in: the robot cannot get there, however it "
            "moves");
}

TEST(FailureText, TellAStartThatIsBoxedIn) {
  const FreeSpace slot = space_for(kSlot, "2.9,0.8; 2.9,-0.8; -2.9,-0.8; -2.9,0.8");
  EXPECT_EQ(answer(slot, between({7, 9, 0}, {4, 3.5, 0}), kTight),
            "unreachable: the start (7,9,E) is boxed in: the robot cannot get from there to the "
            "goal (4,3.5,E), however it moves");
}

/// Two rooms in which the robot drives about. The gap is wide enough for a disc, but not for the robot.
FreeSpace rooms(std::size_t left, std::size_t right) {
  std::string drawing;
  for (int row = 0; row < 15; ++row) {
    const bool gap = row == 3 || row == 4;
    drawing += std::string(left, '.') + (gap ? '.' : '#') + std::string(right, '.') + '\n';
  }
  return space_for(drawing, "1.4,1.1; 1.4,-1.1; -1.4,-1.1; -1.4,1.1");
}

TEST(FailureText, NameTheResolutionAtWhichNothingWasFound) {
  EXPECT_EQ(answer(rooms(15, 15), between({4, 4, 0}, {27, 4, 0}), kTight),
            "unreachable: no drive from the start (4,4,E) to the goal (27,4,E) was found at this "
            "resolution, " +
                kFinely);
}

/// The room of the start is at its end long before that of the goal.
TEST(FailureText, NameTheResolutionThoughOneEndIsSoonDone) {
  EXPECT_EQ(answer(rooms(5, 160), between({3, 4, 0}, {160, 4, 0}), kTight),
            "unreachable: no drive from the start (3,4,E) to the goal (160,4,E) was found at this "
            "resolution, " +
                kFinely);
}

/// The same drawing with cells of 0.1 m, its lower left corner at (-1,2), y up.
FreeSpace metric_space(std::string_view drawing, std::string_view footprint) {
  const GridMap drawn = test::drawn_map(drawing);
  Grid<CellState> cells(drawn.width(), drawn.height(), CellState::free);
  for (int y = 0; y < drawn.height(); ++y) {
    for (int x = 0; x < drawn.width(); ++x) {
      cells[{x, drawn.height() - 1 - y}] = drawn.state({x, y});
    }
  }
  const Frame frame{.resolution = 0.1, .origin = {-1, 2, 0}, .y_up = true, .metric = true};
  return *make_free_space(*make_grid_map(cells, frame), {.footprint = *parse_footprint(footprint)});
}

TEST(FailureText, AreInMetresOnAMapInMetres) {
  const OptionValues tight{{"turning_radius", "0.2"}, {"time_budget", "100"}};
  const FreeSpace yard = metric_space(kYard, "0.14,0.09; 0.14,-0.09; -0.14,-0.09; -0.14,0.09");
  EXPECT_EQ(answer(yard, between({5, 4.5, 0}, {12, 2, 0}), tight),
            "start_blocked: the start (-0.5,2.45,E) m is blocked: the robot's front right "
            "corner lies in the obstacle cell (6,3)");
  EXPECT_EQ(
      answer(yard, between({3, 3, 0}, {30, 3, 1}), tight),
      "goal_outside: the goal (2,2.3) m, cell (30,3) is outside the map, which covers x from -1 "
      "to 0.4 m and y from 2 to 2.7 m");
  const FreeSpace disc = metric_space(kYard, "disc:0.15");
  EXPECT_EQ(answer(disc, between({5.5, 3.5, 0}, {12, 3, 0}), tight),
            "start_blocked: the start (-0.45,2.35,E) m is blocked: the nearest obstacle is 0.05 m "
            "away, the robot's radius is 0.15 m");
  const FreeSpace lorry = metric_space(kYard, "1.2,0.3; 1.2,-0.3; -1.2,-0.3; -1.2,0.3");
  EXPECT_EQ(answer(lorry, between({7, 3.5, 0}, {8, 3.5, 0}), tight),
            "start_blocked: the robot's footprint, 2.4 x 0.6 m, is larger than the map, 1.4 x 0.7 "
            "m");
  EXPECT_EQ(answer(metric_space(kYard, "disc:0.4"), between({3, 3.5, 0}, {8, 3.5, 0}), tight),
            "start_blocked: the robot, a disc with a radius of 0.4 m, is larger than the map, 1.4 "
            "x 0.7 m");
  const FreeSpace slot = metric_space(kSlot, "0.29,0.08; 0.29,-0.08; -0.29,-0.08; -0.29,0.08");
  EXPECT_EQ(answer(slot, between({4, 7.5, 0}, {7, 2, 0}), tight),
            "unreachable: the goal (-0.3,2.2,E) m is boxed in: the robot cannot get there, however "
            "it moves");
}

TEST(FailureText, CountSeveralGoals) {
  const FreeSpace slot = space_for(kSlot, "2.9,0.8; 2.9,-0.8; -2.9,-0.8; -2.9,0.8");
  const Query query{{4, 3.5, 0}, {Goal(Pose{7, 9, 0}), Goal(Pose{7, 9, kPi})}};
  EXPECT_EQ(
      answer(slot, query, kTight),
      "unreachable: each of the 2 goals is boxed in: the robot cannot get there, however it moves");
}

TEST(FailureText, NameAToleranceThatIsTooSmall) {
  const FreeSpace space = test::drawn_space(R"(
..#.
..#.
)");
  const auto planner = make_planner("astar", space);
  ASSERT_TRUE(planner);
  const auto why = [&](Point point, double tolerance) {
    const auto plan = (*planner)->plan({pose_at({0, 0}), {Goal(point, tolerance)}});
    return plan
               ? std::string()
               : std::string(to_string(plan.error().status)) + ": " + words_of(plan.error(), space);
  };
  EXPECT_THAT(
      why({2.5, 0.5}, 0.5),
      HasSubstr("goal_blocked: the goal (2,0) is blocked: the cell is an obstacle. The robot "
                "fits nowhere within its tolerance of 0.5 cells"));
  EXPECT_THAT(why({3.5, 0.5}, 1),
              HasSubstr("No place within its tolerance of 1 cell can be reached"));
  EXPECT_THAT(why({9.5, 0.5}, 2), HasSubstr("goal_outside: "));
  EXPECT_THAT(why({9.5, 0.5}, 2), HasSubstr("does not reach the map"));
  EXPECT_EQ(why({3.5, 0.5}, 2), "");
  for (const double wrong : {-1.0, kNoNumber}) {
    EXPECT_THAT(why({1.5, 0.5}, wrong),
                HasSubstr("unsupported_query: the tolerances of a goal must be at least 0"));
  }
}

}  // namespace
}  // namespace wend
