// What cells near obstacles cost a robot that keeps away from them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/map/random_bits_test.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {
namespace {

constexpr std::array kDistances{0.0, 0.3, 0.5, 1.0, 2.0, 3.7, 20.0, 1e6};  // cells
constexpr std::array kCosts{0.0, 0.01, 1.0, 4.0, 1e6};

/// Calls check(map, options, space) for random maps, radii, distances and costs.
template <class Check>
void on_random_spaces(Check&& check) {
  for (std::uint64_t seed = 1; seed <= test::share_of(600U) && !::testing::Test::HasFailure();
       ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random);
    FreeSpaceOptions options = test::random_robot(random, map.frame().resolution);
    options.clearance_distance = test::one_of(random, kDistances) * map.frame().resolution;
    options.clearance_cost = test::one_of(random, kCosts);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", keeps away " +
                 std::to_string(options.clearance_distance) + " m at " +
                 std::to_string(options.clearance_cost) + "\n" + test::drawing_of(map));
    check(map, options, *make_free_space(map, options));
  }
}

TEST(ClearanceCost, NeverMakesACellCostLess) {
  on_random_spaces([](const GridMap& map, const FreeSpaceOptions&, const FreeSpace& space) {
    for (const Cell cell : test::all_cells(map.width(), map.height())) {
      ASSERT_GE(space.costs().steps(cell), CostMap::rounded(map.terrain(cell)));
      ASSERT_TRUE(std::isfinite(space.terrain(cell)));
    }
  });
}

TEST(ClearanceCost, CostsWhatItsFormulaSays) {
  int raised = 0;
  on_random_spaces([&](const GridMap& map, const FreeSpaceOptions& options,
                       const FreeSpace& space) {
    const test::Reference reference(map, test::robot_in_cells(options, map.frame()), {});
    for (const Cell cell : test::all_cells(map.width(), map.height())) {
      if (!space.passable(cell)) continue;
      const double expected = reference.terrain(cell);
      raised += expected > map.terrain(cell) ? 1 : 0;
      ASSERT_NEAR(space.terrain(cell), expected, 0.5 / CostMap::kOne) << cell.x << "," << cell.y;
    }
  });
  EXPECT_GT(raised, test::share_of(5000));
}

TEST(ClearanceCost, IsNothingWithoutADistanceOrACost) {
  on_random_spaces([](const GridMap& map, FreeSpaceOptions options, const FreeSpace&) {
    for (const auto& [distance, cost] : {std::pair{0.0, 4.0}, {0.0, 1e6}, {3.0, 0.0}}) {
      options.clearance_distance = distance;
      options.clearance_cost = cost;
      const FreeSpace space = *make_free_space(map, options);
      ASSERT_EQ(space.costs(), make_free_space(map, {.unknown = options.unknown})->costs());
    }
  });
}

/// Terrain is uniform where every stored cost is 1, and only there.
TEST(ClearanceCost, IsUniformWhereEveryStoredCostIsOne) {
  std::array<int, 2> seen{};
  on_random_spaces([&](const GridMap& map, const FreeSpaceOptions&, const FreeSpace& space) {
    const auto cells = test::all_cells(map.width(), map.height());
    const bool dear =
        std::any_of(cells.begin(), cells.end(), [&](Cell cell) { return space.terrain(cell) > 1; });
    ASSERT_EQ(space.uniform_terrain(), !dear);
    ++seen[dear ? 1 : 0];
  });
  EXPECT_GT(seen[0], test::share_of(50));
  EXPECT_GT(seen[1], test::share_of(100));
}

TEST(ClearanceCost, RefusesWhatCannotBeStored) {
  const GridMap map = test::drawn_map("#9.");
  const auto space = make_free_space(map, {.clearance_distance = 1, .clearance_cost = 1e8});
  ASSERT_FALSE(space);
  EXPECT_EQ(space.error().status, Status::unsupported_map);
  EXPECT_EQ(space.error().where, "terrain");
  EXPECT_NE(space.error().message.find("the most is 16777"), std::string::npos)
      << space.error().message;
}

TEST(ClearanceCost, IsMeasuredFromTheRobotsEdgeInMetres) {
  // Cells of half a metre, an obstacle on the left: cell x is (x - 0.5) / 2 m from it.
  const GridMap map = test::drawn_map("#.........", {.resolution = 0.5, .metric = true});
  const FreeSpace space = *make_free_space(map, {.footprint = Footprint::disc(0.75),
                                                 .outside = OutsidePolicy::free,
                                                 .clearance_distance = 2,
                                                 .clearance_cost = 8});
  EXPECT_EQ(space.terrain({1, 0}), 1) << "the robot cannot stand there";
  EXPECT_DOUBLE_EQ(space.terrain({2, 0}), 9) << "it touches";
  EXPECT_DOUBLE_EQ(space.terrain({4, 0}), 3) << "1 m away";
  EXPECT_DOUBLE_EQ(space.terrain({5, 0}), 1.5) << "1.5 m away";
  EXPECT_EQ(space.terrain({6, 0}), 1) << "2 m away";
  EXPECT_EQ(space.terrain({9, 0}), 1);
}

TEST(ClearanceCost, MultipliesTheMapsTerrain) {
  const FreeSpace space = test::drawn_space("#33.", {.clearance_distance = 1, .clearance_cost = 4});
  EXPECT_DOUBLE_EQ(space.terrain({1, 0}), 3 * 2) << "half a cell away: 1 + 4 / 4";
  EXPECT_EQ(space.terrain({2, 0}), 3);
}

TEST(ClearanceCost, FadesLessAndLess) {
  const FreeSpace space = *make_free_space(test::drawn_map("#" + std::string(200, '.')),
                                           {.clearance_distance = 100, .clearance_cost = 5});
  double before = space.terrain({1, 0});
  // Each cost is rounded by at most half a step, so each fall by at most one.
  constexpr double kRounding = 1.0 / CostMap::kOne;
  double slope = 0.2;
  for (int x = 2; x <= 200; ++x) {
    const double terrain = space.terrain({x, 0});
    const double fall = before - terrain;
    ASSERT_GE(fall, 0) << x;
    ASSERT_LE(fall, slope + 2 * kRounding) << "falls less and less, at " << x;
    before = terrain;
    slope = fall;
  }
  EXPECT_EQ(before, 1);
}

}  // namespace
}  // namespace wend
