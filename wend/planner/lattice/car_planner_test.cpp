// The car: the numbers that are known of it. That its drives are legal and the cheapest is shown in
// tests/lattice/car_conformance_test.cpp; why it says no, in wend/session/car_failure_test.cpp.

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

TEST(Car, CountsThePosesOfItsPassableCorners) {
  EXPECT_EQ(car_on(test::open_space(3, 2))->state_count(), 4U * 3U * 4U);
  EXPECT_EQ(car_on(test::drawn_space("...\n.#."))->state_count(), 8U * 4U);
}

}  // namespace
}  // namespace wend
