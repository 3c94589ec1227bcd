// Walls one cell thick, straight, diagonal and with gaps at corners, are never crossed, however long the motions of
// the search are; and a hole that is wide enough is.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

#include "conformance/driven_path.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr int kSize = 25;
constexpr std::array kMotionLengths{0.0, 1.0, 2.5, 6.0, 15.0, 40.0};  // cells; 0: the default

/// A wall between two corners of the map or two sides, as the place of its cell in each row.
enum class Wall {
  straight,   // one cell thick
  diagonal,   // cells that touch at corners only
  staggered,  // two straight halves whose ends touch at a corner
};

int wall_in(Wall wall, int row) {
  if (wall == Wall::diagonal) return row;
  return wall == Wall::straight || row < kSize / 2 ? kSize / 2 : kSize / 2 + 1;
}

/// A map that a wall parts, with a hole of some rows from `hole` on.
GridMap parted_map(Wall wall, int hole, int rows) {
  Grid<CellState> states(kSize, kSize, CellState::free);
  for (int row = 0; row < kSize; ++row) {
    if (row < hole || row >= hole + rows) states[{wall_in(wall, row), row}] = CellState::occupied;
  }
  return *make_grid_map(states);
}

/// A pose on one side of the wall at which the robot fits.
Pose pose_beside(Random& random, const FreeSpace& space, Wall wall, bool left) {
  Pose pose;
  do {
    pose = {kSize * random.uniform(), kSize * random.uniform(), 2 * kPi * random.uniform() - kPi};
  } while (!space.fits(pose) ||
           (cell_at(pose.point()).x < wall_in(wall, cell_at(pose.point()).y)) != left);
  return pose;
}

struct ThinWall {
  Wall wall;
  std::string_view footprint;
};

class ThinWalls : public ::testing::TestWithParam<ThinWall> {
 protected:
  FreeSpace space_with_hole(int hole, int rows) const {
    return *make_free_space(
        parted_map(GetParam().wall, hole, rows),
        {.footprint = *parse_footprint(GetParam().footprint), .outside = OutsidePolicy::blocked});
  }

  Query across(Random& random, const FreeSpace& space) const {
    const bool left = random.chance(0.5);
    const Pose start = pose_beside(random, space, GetParam().wall, left);
    return {start, {Goal(pose_beside(random, space, GetParam().wall, !left))}};
  }

  static OptionValues options_for(double motion_length, std::string_view model) {
    return {{"turning_radius", model == "differential" ? "0" : "2"},
            {"motion_model", std::string(model)},
            {"motion_length", fmt::format("{}", motion_length)},
            {"time_budget", "1000"}};  // on slow machines, too
  }
};

constexpr std::array<std::string_view, 2> kModels{"reeds_shepp", "dubins"};

TEST_P(ThinWalls, AreNotCrossed) {
  const FreeSpace space = space_with_hole(0, 0);
  for (const std::string_view model : kModels) {
    for (const double length : kMotionLengths) {
      SCOPED_TRACE(fmt::format("{}, motions of {} cells", model, length));
      const auto planner = *make_planner("hybrid_astar", space, options_for(length, model));
      for (std::uint64_t seed = 0; seed < share_of(4U); ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        Random random(seed);
        const auto plan = planner->plan(across(random, space));
        ASSERT_FALSE(plan);
        EXPECT_EQ(plan.error().status, Status::unreachable);
      }
    }
  }
}

/// A hole of five cells: every drive leads through it, or is none.
TEST_P(ThinWalls, AreCrossedThroughTheirHoles) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < share_of(6U); ++seed) {
    Random random(seed);
    const int hole = random.between(3, kSize - 9);
    const FreeSpace space = space_with_hole(hole, 5);
    const Query query = across(random, space);
    for (const double length : kMotionLengths) {
      SCOPED_TRACE(fmt::format("seed {}, motions of {} cells", seed, length));
      const auto planner = *make_planner("hybrid_astar", space, options_for(length, "reeds_shepp"));
      const auto plan = planner->plan(query);
      if (!plan) continue;
      ++found;
      EXPECT_EQ(checked_drive(space, plan->path, query, {.turning_radius = 2, .step = 0.02}).fault,
                "");
    }
  }
  EXPECT_GT(found, static_cast<int>(share_of(20U)));
}

/// The length of motions, in cells.
class ThinWallsWithSlits : public ::testing::TestWithParam<double> {};

/// A slit that its disc passes, but not the bar behind it: the searches look at it again and again.
TEST_P(ThinWallsWithSlits, AreNotCrossedByARobotWiderThanItsDisc) {
  const Footprint robot = *parse_footprint(
      "0.5,0.4; -0.4,0.4; -0.4,1.2; -0.8,1.2; -0.8,-1.2; -0.4,-1.2; -0.4,-0.4; 0.5,-0.4");
  const FreeSpace space = *make_free_space(parted_map(Wall::straight, kSize / 2, 1),
                                           {.footprint = robot, .outside = OutsidePolicy::blocked});
  const auto planner = *make_planner("hybrid_astar", space,
                                     {{"turning_radius", "2"},
                                      {"motion_length", fmt::format("{}", GetParam())},
                                      {"time_budget", "1000"}});
  const auto plan = planner->plan({{4.5, 12.5, 0}, {Goal(Pose{20.5, 12.5, 0})}});
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().status, Status::unreachable);
  EXPECT_GT(plan.error().metrics.expanded, 100U);
}

INSTANTIATE_TEST_SUITE_P(Lengths, ThinWallsWithSlits, ::testing::Values(0.0, 6.0, 40.0),
                         [](const auto& tested) { return fmt::format("{}", tested.param); });

INSTANTIATE_TEST_SUITE_P(
    Walls, ThinWalls,
    ::testing::Values(ThinWall{Wall::straight, "disc:0.05"}, ThinWall{Wall::straight, "disc:0.6"},
                      ThinWall{Wall::straight, "0.8,0.3; -0.4,0.3; -0.4,-0.3; 0.8,-0.3"},
                      ThinWall{Wall::diagonal, "disc:0.05"}, ThinWall{Wall::diagonal, "disc:0.6"},
                      ThinWall{Wall::diagonal, "0.8,0.3; -0.4,0.3; -0.4,-0.3; 0.8,-0.3"},
                      ThinWall{Wall::staggered, "disc:0.05"},
                      ThinWall{Wall::staggered, "0.8,0.02; -0.4,0.02; -0.4,-0.02; 0.8,-0.02"}),
    [](const auto& tested) { return fmt::format("{}", tested.index); });

}  // namespace
}  // namespace wend::test
