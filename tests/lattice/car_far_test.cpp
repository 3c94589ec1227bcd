// Drives so long that their costs outgrow 32 bits, in which short ones are counted.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "conformance/answer.hpp"
#include "tests/testing/car_simulator.hpp"
#include "tests/testing/car_trial.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kFarRelative = 1e-9;
constexpr double kOutgrown = 65'000;  // fuel
constexpr double kRough = 5;

GridMap rough_map(Grid<CellState> states) {
  Grid<double> terrain(states.width(), states.height(), kRough);
  return *make_grid_map(std::move(states), {}, std::move(terrain));
}

/// Lanes two cells wide, joined at alternating ends, where the map's edge leaves room for one turn.
GridMap serpentine(int width, int lanes) {
  constexpr int kPitch = 3;
  Grid<CellState> states(width, lanes * kPitch - 1, CellState::free);
  for (int lane = 1; lane < lanes; ++lane) {
    const bool right = lane % 2 == 1;
    for (int x = 0; x < width - 1; ++x) {
      states[{right ? x : x + 1, lane * kPitch - 1}] = CellState::occupied;
    }
  }
  return rough_map(std::move(states));
}

class FarCar : public ::testing::TestWithParam<std::string> {
 protected:
  static std::unique_ptr<Planner> make(const GridMap& map) {
    return make_planner("car", *make_free_space(map),
                        {{"heuristic", GetParam()}, {"straight_terrain", "mean"}})
        .value();
  }
};

TEST_P(FarCar, DrivesThroughASerpentine) {
  const GridMap map = serpentine(210, 67);
  const CarReference reference(map, {}, {.straight_terrain = "mean"});
  const Stand start{{0, 1}, 0};
  const Stand goal{{reference.columns() - 1, reference.rows() - 2}, 0};
  const double fuel = reference.fuel_from(start)[reference.number(goal)];
  ASSERT_GT(fuel, kOutgrown);
  ASSERT_LT(fuel, kInfinite);

  const auto planner = make(map);
  const Query query{reference.pose(start), {reference.pose(goal)}};
  const Answer answer = answer_of(*planner, query);
  ASSERT_EQ(to_string(answer.status), "found");
  EXPECT_NEAR(answer.plan.cost, fuel, kFarRelative * fuel);
  EXPECT_EQ(fault_of(answer.plan, reference), "");

  // What is known of the map by now, a step at a time or watched from the start: all the same.
  EXPECT_EQ(answer_of(*planner, query), answer);
  EXPECT_EQ(stepping_fault(*make(map), *planners().find("car"), query, answer), "");
}

TEST_P(FarCar, HoldsItsLimitsAfterItsCostsOutgrewTheirBits) {
  const GridMap map = serpentine(210, 67);
  Query query{{0, 1, 0}, {Pose{210, 199, 0}}};
  const std::uint64_t needed = answer_of(*make(map), query).plan.metrics.expanded;
  query.limits.expansions = needed - 1;
  const Answer answer = answer_of(*make(map), query);
  EXPECT_EQ(to_string(answer.status), "expansion_limit");
  EXPECT_EQ(answer.plan.metrics.expanded, needed - 1);
}

TEST_P(FarCar, DrivesDownALongLane) {
  constexpr int kLength = 14'000;
  const auto planner = make(rough_map(Grid<CellState>(kLength, 1, CellState::free)));
  const auto plan = planner->plan({{0, 0, 0}, {Pose{kLength, 0, 0}}});
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan->cost, kRough * kLength, kFarRelative * kRough * kLength);
}

INSTANTIATE_TEST_SUITE_P(Heuristics, FarCar,
                         ::testing::Values("zero", "diagonal", "headings", "obstacles"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
