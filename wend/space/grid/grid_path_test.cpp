#include "wend/space/grid/grid_path.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"

namespace wend {
namespace {

/// Walks on random legal steps.
std::vector<Cell> random_walk(Random& random, const test::Reference& reference, Cell from,
                              int steps) {
  std::vector<Cell> path{from};
  while (steps-- > 0) {
    const Cell to{path.back().x + random.between(-1, 1), path.back().y + random.between(-1, 1)};
    if (reference.is_step(path.back(), to)) path.push_back(to);
  }
  return path;
}

TEST(GridPath, CostsWhatTheReferenceSays) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GridMap map = test::random_map(random);
    const FreeSpace space = *make_free_space(map);
    const test::Reference reference(map, {}, {});
    const Cell start = test::random_cell(random, map.width(), map.height());
    if (!space.passable(start)) continue;
    const auto path = random_walk(random, reference, start, 100);
    const double cost = reference.cost_of(path);
    EXPECT_NEAR(grid_path_cost(space, path), cost, 1e-9 * (1 + cost));
    const auto checked = check_grid_path(space, {}, path);
    ASSERT_TRUE(checked) << checked.error().what;
    EXPECT_EQ(*checked, grid_path_cost(space, path));
  }
}

/// Steps are counted, not added up: the order of the steps does not show in the last bit.
TEST(GridPath, OfEqualLengthsCostTheSameToTheLastBit) {
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(200, 100, CellState::free)));
  std::vector<Cell> diagonal_first{{0, 0}};
  std::vector<Cell> mixed{{0, 0}};
  const auto go = [](std::vector<Cell>& path, int dx, int dy) {
    path.push_back({path.back().x + dx, path.back().y + dy});
  };
  for (int i = 0; i < 99; ++i) go(diagonal_first, 1, 1);
  for (int i = 0; i < 99; ++i) go(diagonal_first, 1, 0);
  for (int i = 0; i < 99; ++i) {
    go(mixed, 1, 0);
    go(mixed, 1, 1);
  }
  EXPECT_EQ(grid_path_cost(space, diagonal_first), grid_path_cost(space, mixed));
  EXPECT_EQ(grid_path_cost(space, mixed), 99 + std::numbers::sqrt2 * 99);
}

TEST(GridPath, OfOneCellOrNoneCostsNothing) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(2, 2, CellState::free)));
  EXPECT_EQ(grid_path_cost(space, {}), 0);
  EXPECT_EQ(grid_path_cost(space, std::vector<Cell>{{1, 1}}), 0);
  EXPECT_EQ(check_grid_path(space, {}, {}).value_or(-1), 0);
}

/// # at (1,1) and ? at (3,0).
FreeSpace small_space() {
  Grid<CellState> states(4, 3, CellState::free);
  states[{1, 1}] = CellState::occupied;
  states[{3, 0}] = CellState::unknown;
  return *make_free_space(*make_grid_map(states));
}

struct Faulty {
  std::vector<Cell> path;
  GridMoves moves;
  std::size_t index;
  std::string what;
};

TEST(GridPath, NamesTheFirstFault) {
  const GridMoves four{Connectivity::four, CornerRule::none};
  const GridMoves eight{};
  const std::vector<Faulty> all{
      {{{0, 1}, {1, 1}}, eight, 1, "cell (1,1) is an obstacle"},
      {{{2, 0}, {3, 0}}, eight, 1, "cell (3,0) is unknown"},
      {{{0, 0}, {-1, 0}}, eight, 1, "cell (-1,0) is outside the map"},
      {{{4, 0}}, eight, 0, "cell (4,0) is outside the map"},
      {{{0, 0}, {2, 0}}, eight, 1, "(0,0) to (2,0) is no step"},
      {{{0, 0}, {0, 0}}, eight, 1, "(0,0) to (0,0) is no step"},
      {{{0, 0}, {1, 0}, {0, 1}}, eight, 2, "(1,0) to (0,1) is no step"},
      {{{2, 1}, {3, 2}}, four, 1, "(2,1) to (3,2) is no step"},
  };
  for (const Faulty& faulty : all) {
    const auto checked = check_grid_path(small_space(), faulty.moves, faulty.path);
    ASSERT_FALSE(checked) << faulty.what;
    EXPECT_EQ(checked.error().what, faulty.what);
    EXPECT_EQ(checked.error().index, faulty.index) << faulty.what;
  }
}

TEST(GridPath, AllowsWhatTheCornerRuleAllows) {
  const std::vector<Cell> around{{1, 0}, {0, 1}};
  EXPECT_TRUE(check_grid_path(small_space(), {Connectivity::eight, CornerRule::one}, around));
  EXPECT_FALSE(check_grid_path(small_space(), {Connectivity::eight, CornerRule::none}, around));
}

}  // namespace
}  // namespace wend
