// The car: the numbers that are known of it, and why it says no. That its drives are
// legal and the cheapest is shown in tests/lattice/car_conformance_test.cpp.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/geometry/corner_pose.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::unique_ptr<Planner> car_on(const FreeSpace& space, const OptionValues& options = {}) {
  return std::move(make_planner("car", space, options).value());
}

FreeSpace open_yard(int width, int height, bool y_up) {
  Frame frame;
  frame.y_up = y_up;
  return *make_free_space(*make_grid_map(Grid<CellState>(width, height, CellState::free), frame));
}

Pose at(int x, int y, Heading heading) { return pose_of({{x, y}, heading}); }

TEST(Car, NeedsNinePiToCrossAYardOfNineteenCells) {
  for (const bool y_up : {false, true}) {
    const auto planner = car_on(open_yard(19, 19, y_up));
    const auto plan = planner->plan({at(0, 0, Heading::plus_x), {at(18, 18, Heading::plus_x)}});
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->moves.size(), 18U);
    EXPECT_NEAR(plan->cost, 9 * kPi, 1e-12);
    EXPECT_TRUE(plan->optimal());
  }
}

struct OneMove {
  std::string_view name;
  Pose to;
};

TEST(Car, MakesEachOfItsSixMoves) {
  const auto planner = car_on(test::open_space(5, 5));
  const auto expect_move = [&](const Pose& from, const OneMove& move) {
    const auto plan = planner->plan({from, {move.to}});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_THAT(plan->moves, ElementsAre(move.name));
    EXPECT_THAT(plan->path.poses(), ElementsAre(from, move.to));
  };
  expect_move(at(1, 0, Heading::plus_x), {"FWD_RIGHT", at(2, 1, Heading::plus_y)});
  for (const OneMove& move :
       {OneMove{"FWD", at(3, 2, Heading::plus_x)}, OneMove{"FWD_RIGHT", at(3, 3, Heading::plus_y)},
        OneMove{"FWD_LEFT", at(3, 1, Heading::minus_y)}, OneMove{"REV", at(1, 2, Heading::plus_x)},
        OneMove{"REV_RIGHT", at(1, 3, Heading::minus_y)},
        OneMove{"REV_LEFT", at(1, 1, Heading::plus_y)}}) {
    expect_move(at(2, 2, Heading::plus_x), move);
  }
}

TEST(Car, NamesItsMovesAsPeopleSeeThemWhereYIsUp) {
  const auto planner = car_on(open_yard(5, 5, true));
  const auto plan = planner->plan({at(2, 2, Heading::plus_x), {at(1, 1, Heading::plus_y)}});
  ASSERT_TRUE(plan);
  EXPECT_THAT(plan->moves, ElementsAre("REV_RIGHT"));
}

TEST(Car, SaysByHowMuchItMissesWhatWasAsked) {
  const auto planner = car_on(test::open_space(9, 9), {{"lattice_resolution", "3"}});
  const Query query{{0.3, 0.4, 0.25}, {Goal(Point{7.6, 9}), Goal(Point{4, 3})}};
  const auto plan = planner->plan(query);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->path.poses().back().point(), (Point{3, 3}));
  EXPECT_NEAR(plan->start_snapping_error.distance, 0.5, 1e-12);
  EXPECT_NEAR(plan->start_snapping_error.turn, 0.25, 1e-12);
  EXPECT_NEAR(plan->goal_snapping_error.distance, 1, 1e-12);
  EXPECT_EQ(plan->goal_snapping_error.turn, 0);
}

constexpr std::string_view kYard = R"(
.....#...
.....#...
...#.?...
.........
)";
struct Refusal {
  std::string status;
  std::string reason;
};

Refusal refusal_of(Planner& planner, const Query& query) {
  const auto plan = planner.plan(query);
  if (plan) return {"found", ""};
  EXPECT_EQ(plan.error().message, planner.reason(query, plan.error().status));
  return {std::string(to_string(plan.error().status)), plan.error().message};
}

void expect_refusal(Planner& planner, const Query& query, const std::string& status,
                    const std::string& reason) {
  const Refusal refusal = refusal_of(planner, query);
  EXPECT_EQ(refusal.status, status);
  EXPECT_EQ(refusal.reason, reason);
}

TEST(Car, NamesThePlaceAndTheCauseOfARefusal) {
  const auto planner = car_on(test::drawn_space(kYard));
  const Pose here = at(1, 1, Heading::plus_x);
  expect_refusal(*planner, {{9.5, 0, 0}, {here}}, "start_outside",
                 "the start (9.5,0) is outside the map: its grid vertices have x from 0 to 9 and y "
                 "from 0 to 4");
  expect_refusal(
      *planner, {here, {Goal(Point{0, -1})}}, "goal_outside",
      "the goal (0,-1) is outside the map: its grid vertices have x from 0 to 9 and y from 0 to 4");
  expect_refusal(*planner, {at(5, 1, Heading::minus_y), {here}}, "start_blocked",
                 "the start (5,1,N) is impassable: cell (5,0) next to it is an obstacle");
  expect_refusal(*planner, {here, {Goal(Point{6, 3})}}, "goal_blocked",
                 "the goal (6,3,any) is impassable: cell (5,2) next to it is unknown");
  expect_refusal(*planner, {here, {}}, "unsupported_query", "the query has no goal");
}

TEST(Car, SaysWhenItIsBoxedIn) {
  const auto planner = car_on(test::drawn_space(R"(
..#.....
..#.....
###.....
........
)"));
  expect_refusal(*planner, {at(5, 2, Heading::plus_x), {at(0, 0, Heading::plus_x)}}, "unreachable",
                 "there is no path from the start (5,2,E) to the goal (0,0,E): obstacles separate "
                 "them for the car");
  const auto tight = car_on(test::drawn_space(R"(
.#...
##...
.....
)"));
  expect_refusal(*tight, {at(0, 0, Heading::plus_y), {at(4, 2, Heading::plus_x)}}, "unreachable",
                 "no motion primitive leaves the start (0,0,S)");
  expect_refusal(*tight, {at(4, 2, Heading::plus_x), {Goal(Point{0, 0})}}, "unreachable",
                 "no motion primitive reaches the goal (0,0,any)");
}

TEST(Car, ThatIsTooWideSaysHowFarTheObstacleIs) {
  const auto planner =
      car_on(test::drawn_space("....\n....\n....\n...#", {.footprint = Footprint::disc(1.5)}));
  expect_refusal(*planner, {at(2, 3, Heading::plus_x), {at(0, 0, Heading::plus_x)}},
                 "start_blocked",
                 "the start (2,3,E) is impassable: the nearest obstacle is 1 cell away, the "
                 "robot's radius is 1.5 cells");
}

TEST(Car, GivesReasonsInMetresOnAMapInMetres) {
  const auto planner_for = [](double radius) {
    Grid<CellState> cells(6, 4, CellState::free);
    cells[{5, 0}] = CellState::occupied;
    const Frame frame{.resolution = 0.5, .origin = {1, 2, 0}, .y_up = true, .metric = true};
    return car_on(
        *make_free_space(*make_grid_map(cells, frame), {.footprint = Footprint::disc(radius)}));
  };
  const auto planner = planner_for(0);
  const Pose here = at(1, 1, Heading::plus_x);
  expect_refusal(*planner, {{9.5, 0, 0}, {here}}, "start_outside",
                 "the start (5.75,2) m is outside the map, which covers x from 1 to 4 m and y "
                 "from 2 to 4 m");
  expect_refusal(*planner, {here, {Goal(Point{5, 1})}}, "goal_blocked",
                 "the goal (3.5,2.5,any) m is impassable: cell (5,0) next to it is an obstacle");
  expect_refusal(*planner_for(0.75), {at(4, 2, Heading::plus_y), {here}}, "start_blocked",
                 "the start (3,3,N) m is impassable: the nearest obstacle is 0.707 m away, the "
                 "robot's radius is 0.75 m");
}

TEST(Car, RefusesWhatIsNoNumber) {
  const auto planner = car_on(test::drawn_space(kYard));
  const Pose here = at(1, 1, Heading::plus_x);
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    expect_refusal(*planner, {{1, 1, bad}, {here}}, "unsupported_query",
                   "the headings of the start and the goal must be finite numbers");
    expect_refusal(*planner, {here, {Pose{1, 1, bad}}}, "unsupported_query",
                   "the headings of the start and the goal must be finite numbers");
    EXPECT_EQ(refusal_of(*planner, {{bad, 1, 0}, {here}}).status, "start_outside");
    EXPECT_EQ(refusal_of(*planner, {here, {Goal(Point{1, bad})}}).status, "goal_outside");
  }
  EXPECT_EQ(refusal_of(*planner, {{1e300, 1, 0}, {here}}).status, "start_outside");
  EXPECT_EQ(refusal_of(*planner, {{1, 1, 1e15}, {here}}).status, "found");
}

TEST(Car, IfAllGoalsAreHopelessGivesTheReasonOfTheFirst) {
  const auto planner = car_on(test::drawn_space(kYard));
  const Pose start = at(1, 1, Heading::plus_x);
  const Pose outside{20, 20, 0};
  const Pose blocked = at(5, 1, Heading::minus_y);
  EXPECT_EQ(refusal_of(*planner, {start, {outside, blocked}}).status, "goal_outside");
  EXPECT_EQ(refusal_of(*planner, {start, {blocked, outside}}).status, "goal_blocked");
  EXPECT_EQ(refusal_of(*planner, {start, {blocked, outside, at(2, 1, Heading::plus_x)}}).status,
            "found");
}

/// What is no goal of the search is not what it says it did not reach.
TEST(Car, SaysWhichGoalItSearchedForInVain) {
  const auto planner = car_on(test::drawn_space("...#\n.#..\n....\n...."));
  const Pose start = at(2, 4, Heading::plus_x);
  const Goal outside(Point{20, 20});
  const Goal blocked(Point{2, 1});
  // The way to it leads around the corner (0,0), along two edges of the map.
  const Goal hopeless(at(1, 0, Heading::plus_y));
  expect_refusal(*planner, {start, {outside, blocked, hopeless}}, "unreachable",
                 "there is no path from the start (2,4,E) to the goal (1,0,S): obstacles separate "
                 "them for the car");
}

TEST(Car, SaysOfAMapThatItIsTooSmall) {
  const auto made = make_planner("car", test::open_space(4, 2), {{"lattice_resolution", "3"}});
  ASSERT_FALSE(made);
  EXPECT_EQ(to_string(made.error().status), "unsupported_map");
  const std::string why = "the map of 4 x 2 cells is too small for a lattice_resolution of 3";
  EXPECT_EQ(made.error().message, why);
  const auto planner = car_on(test::open_space(9, 9), {{"lattice_resolution", "3"}});
  planner->update(test::open_space(4, 2));
  expect_refusal(*planner, {at(0, 0, Heading::plus_x), {at(0, 0, Heading::plus_x)}},
                 "unsupported_map", why);
  EXPECT_EQ(planner->state_count(), 0U);
  EXPECT_EQ(planner->heuristic(Pose{0, 0, 0}), 0);
}

TEST(Car, CountsThePosesOfItsPassableCorners) {
  EXPECT_EQ(car_on(test::open_space(3, 2))->state_count(), 4U * 3U * 4U);
  EXPECT_EQ(car_on(test::drawn_space("...\n.#."))->state_count(), 8U * 4U);
}

}  // namespace
}  // namespace wend
