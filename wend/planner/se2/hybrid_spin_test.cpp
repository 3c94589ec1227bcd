// Robots that turn in place, or move in every direction: what they find is free and ends at the goal.

#include <gtest/gtest.h>

#include <string>

#include "conformance/driven_path.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

class HybridAStarInPlace : public ::testing::TestWithParam<std::string> {};

/// Their searches meet poses exactly at the goal, of which no table of arrivals knows anything.
TEST_P(HybridAStarInPlace, FindsFreePathsBetweenMiddlesOfCells) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    constexpr int kSide = 20;
    Grid<CellState> states(kSide, kSide, CellState::free);
    for (const Cell cell : every_cell(states)) {
      if (random.chance(0.03)) states[cell] = CellState::occupied;
    }
    const FreeSpace space =
        *make_free_space(*make_grid_map(states), {.footprint = Footprint::disc(1)});
    const auto pose = [&] {
      const int x = random.between(0, kSide - 1);
      const int y = random.between(0, kSide - 1);
      return Pose{x + 0.5, y + 0.5, 2 * kPi * random.uniform() - kPi};
    };
    const Pose start = pose();
    const Query query{start, {Goal(pose())}};
    const auto planner = *make_planner("hybrid_astar", space,
                                       {{"motion_model", GetParam()}, {"turning_radius", "0"}});
    const auto plan = planner->plan(query);
    if (!plan) continue;
    ++found;
    EXPECT_EQ(test::checked_drive(space, plan->path, query,
                                  {.turns_in_place = true, .moves_aside = GetParam() == "omni"})
                  .fault,
              "");
  }
  EXPECT_GT(found, 20);
}

INSTANTIATE_TEST_SUITE_P(Models, HybridAStarInPlace, ::testing::Values("differential", "omni"));

}  // namespace
}  // namespace wend
