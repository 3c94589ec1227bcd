#include "wend/space/grid/sight_grid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/share.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

using test::Reference;

/// Compares what cells see with brute force; returns how many pairs of cells see each other.
int compare_sights(std::uint64_t seed, bool of_a_point, CornerRule rule) {
  Random random(seed);
  const GridMap map = test::random_map(random);
  FreeSpaceOptions options = test::random_robot(random, map.frame().resolution);
  if (of_a_point) options.footprint = Footprint::disc(0);
  const FreeSpace space = *make_free_space(map, options);
  const SightGrid grid(space, rule);
  const test::Rules rules{.corners_cut = static_cast<int>(rule)};
  const Reference reference(map, test::robot_in_cells(options, map.frame()), rules);
  int seen = 0;
  for (int i = 0; i < 20; ++i) {
    const Cell a = test::random_cell(random, map.width(), map.height());
    const Cell b = test::random_cell(random, map.width(), map.height());
    if (!space.passable(a) || !space.passable(b)) continue;
    const bool sees = grid.sees(grid.state(a), grid.state(b));
    const std::string fault = reference.any_angle_fault(std::array{a, b}, a, b);
    EXPECT_EQ(sees, fault.empty()) << a.x << ',' << a.y << " to " << b.x << ',' << b.y;
    EXPECT_EQ(grid.sees(grid.state(b), grid.state(a)), sees) << "sight is mutual";
    seen += sees ? 1 : 0;
  }
  return seen;
}

TEST(SightGrid, SeesWhatBruteForceSees) {
  for (const bool of_a_point : {true, false}) {
    int seen = 0;
    for (const CornerRule rule : {CornerRule::none, CornerRule::one, CornerRule::both}) {
      for (std::uint64_t seed = 1; seed <= test::share_of(1000U) && !::testing::Test::HasFailure();
           ++seed) {
        SCOPED_TRACE(seed);
        seen += compare_sights(seed, of_a_point, rule);
      }
    }
    EXPECT_GT(seen, 1000);
  }
}

TEST(SightGrid, KnowsDistances) {
  const SightGrid grid(*make_free_space(*make_grid_map(Grid<CellState>(9, 9, CellState::free))));
  EXPECT_EQ(grid.distance(grid.state({1, 2}), grid.state({4, 6})), 5);
  EXPECT_EQ(grid.distance(grid.state({4, 6}), grid.state({1, 2})), 5);
}

TEST(AnyAnglePath, IsCheckedLineByLine) {
  Grid<CellState> cells(5, 5, CellState::free);
  cells[{2, 1}] = CellState::occupied;
  const FreeSpace space = *make_free_space(*make_grid_map(cells));
  const auto checked = [&](std::initializer_list<Cell> path) {
    return check_any_angle_path(space, Adjacency::edges, std::vector<Cell>(path));
  };
  const auto length = checked({{0, 0}, {3, 0}, {3, 4}});
  ASSERT_TRUE(length) << length.error().what;
  EXPECT_EQ(*length, 7);
  const auto through = checked({{0, 0}, {1, 1}, {3, 1}});
  ASSERT_FALSE(through);
  EXPECT_EQ(through.error().index, 2U);
  EXPECT_EQ(through.error().what, "(1,1) to (3,1) is not free");
  const auto blocked = checked({{0, 0}, {2, 1}});
  ASSERT_FALSE(blocked);
  EXPECT_EQ(blocked.error().what, "cell (2,1) is an obstacle");
}

}  // namespace
}  // namespace wend
