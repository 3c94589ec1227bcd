// Why the car finds no drive, in words.

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "tests/testing/drawn_map.hpp"
#include "wend/geometry/corner_pose.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/failure_text.hpp"

namespace wend {
namespace {

std::unique_ptr<Planner> car_on(const FreeSpace& space, const OptionValues& options = {}) {
  return std::move(make_planner("car", space, options).value());
}

Pose at(int x, int y, Heading heading) { return pose_of({{x, y}, heading}); }

constexpr std::string_view kCarYard = R"(
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
  return {std::string(to_string(plan.error().status)),
          words_of(plan.error(), planner.free_space())};
}

void expect_refusal(Planner& planner, const Query& query, const std::string& status,
                    const std::string& reason) {
  const Refusal refusal = refusal_of(planner, query);
  EXPECT_EQ(refusal.status, status);
  EXPECT_EQ(refusal.reason, reason);
}

TEST(CarFailure, NamesThePlaceAndTheCauseOfARefusal) {
  const auto planner = car_on(test::drawn_space(kCarYard));
  const Pose here = at(1, 1, Heading::plus_x);
  expect_refusal(*planner, {{9.5, 0, 0}, {here}}, "start_outside",
                 "the start (9.5,0), cell (9,0) is outside the map, which covers the grid vertices "
                 "with x from 0 to 9 and y from 0 to 4");
  expect_refusal(
      *planner, {here, {Goal(Point{0, -1})}}, "goal_outside",
      "the goal (0,-1), cell (0,-1) is outside the map, which covers the grid vertices with x from "
      "0 to 9 and y from 0 to 4");
  expect_refusal(*planner, {at(5, 1, Heading::minus_y), {here}}, "start_blocked",
                 "the start (5,1,N) is blocked: cell (5,0) next to it is an obstacle");
  expect_refusal(*planner, {here, {Goal(Point{6, 3})}}, "goal_blocked",
                 "the goal (6,3,any) is blocked: cell (5,2) next to it is unknown");
  expect_refusal(*planner, {here, {}}, "unsupported_query", "the query has no goal");
}

TEST(CarFailure, SaysWhenItIsBoxedIn) {
  const auto planner = car_on(test::drawn_space(R"(
..#.....
..#.....
###.....
........
)"));
  expect_refusal(*planner, {at(5, 2, Heading::plus_x), {at(0, 0, Heading::plus_x)}}, "unreachable",
                 "there is no path from start (5,2,E) to goal (0,0,E): no sequence of motion "
                 "primitives leads there");
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

TEST(CarFailure, ThatIsTooWideSaysHowFarTheObstacleIs) {
  const auto planner =
      car_on(test::drawn_space("....\n....\n....\n...#", {.footprint = Footprint::disc(1.5)}));
  expect_refusal(*planner, {at(2, 3, Heading::plus_x), {at(0, 0, Heading::plus_x)}},
                 "start_blocked",
                 "the start (2,3,E) is blocked: the nearest obstacle is 1 cell away, the "
                 "robot's radius is 1.5 cells");
}

TEST(CarFailure, GivesReasonsInMetresOnAMapInMetres) {
  const auto planner_for = [](double radius) {
    Grid<CellState> cells(6, 4, CellState::free);
    cells[{5, 0}] = CellState::occupied;
    const Frame frame{.resolution = 0.5, .origin = {1, 2, 0}, .y_up = true, .metric = true};
    return car_on(
        *make_free_space(*make_grid_map(cells, frame), {.footprint = Footprint::disc(radius)}));
  };
  const auto planner = planner_for(0);
  const Pose here = at(1, 1, Heading::plus_x);
  expect_refusal(
      *planner, {{9.5, 0, 0}, {here}}, "start_outside",
      "the start (5.75,2) m, cell (9,0) is outside the map, which covers x from 1 to 4 m and y "
      "from 2 to 4 m");
  expect_refusal(*planner, {here, {Goal(Point{5, 1})}}, "goal_blocked",
                 "the goal (3.5,2.5,any) m is blocked: cell (5,0) next to it is an obstacle");
  expect_refusal(*planner_for(0.75), {at(4, 2, Heading::plus_y), {here}}, "start_blocked",
                 "the start (3,3,N) m is blocked: the nearest obstacle is 0.707 m away, the "
                 "robot's radius is 0.75 m");
}

TEST(CarFailure, RefusesWhatIsNoNumber) {
  const auto planner = car_on(test::drawn_space(kCarYard));
  const Pose here = at(1, 1, Heading::plus_x);
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kEndless, -kEndless}) {
    expect_refusal(*planner, {{1, 1, bad}, {here}}, "unsupported_query",
                   "the heading of the start is not a finite number");
    expect_refusal(*planner, {here, {Pose{1, 1, bad}}}, "unsupported_query",
                   "the heading of the goal is not a finite number");
    EXPECT_EQ(refusal_of(*planner, {{bad, 1, 0}, {here}}).status, "start_outside");
    EXPECT_EQ(refusal_of(*planner, {here, {Goal(Point{1, bad})}}).status, "goal_outside");
  }
  EXPECT_EQ(refusal_of(*planner, {{1e300, 1, 0}, {here}}).status, "start_outside");
  EXPECT_EQ(refusal_of(*planner, {{1, 1, 1e15}, {here}}).status, "found");
}

TEST(CarFailure, IfAllGoalsAreHopelessGivesTheReasonOfTheFirst) {
  const auto planner = car_on(test::drawn_space(kCarYard));
  const Pose start = at(1, 1, Heading::plus_x);
  const Pose outside{20, 20, 0};
  const Pose blocked = at(5, 1, Heading::minus_y);
  EXPECT_EQ(refusal_of(*planner, {start, {outside, blocked}}).status, "goal_outside");
  EXPECT_EQ(refusal_of(*planner, {start, {blocked, outside}}).status, "goal_blocked");
  EXPECT_EQ(refusal_of(*planner, {start, {blocked, outside, at(2, 1, Heading::plus_x)}}).status,
            "found");
}

TEST(CarFailure, SaysOfEachGoalWhyItIsNotReached) {
  const auto planner = car_on(test::drawn_space("...#\n.#..\n....\n...."));
  const Pose start = at(2, 4, Heading::plus_x);
  const Goal outside(Point{20, 20});
  const Goal blocked(Point{2, 1});
  // The way to it leads around the corner (0,0), along two edges of the map.
  const Goal hopeless(at(1, 0, Heading::plus_y));
  expect_refusal(*planner, {start, {outside, blocked, hopeless}}, "unreachable",
                 "none of 3 goals can be reached: the goal (20,20), cell (20,20) is outside the "
                 "map, which covers "
                 "the grid vertices with x from 0 to 4 and y from 0 to 4; the goal (2,1,any) is "
                 "blocked: cell (1,1) "
                 "next to it is an obstacle; there is no path to the goal (1,0,S)");
}

TEST(CarFailure, SaysOfAMapThatItIsTooSmall) {
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

}  // namespace
}  // namespace wend
