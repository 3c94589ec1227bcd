#include "wend/planner/costs/side_rooms.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "conformance/random_edit.hpp"
#include "tests/testing/share.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/costs/cost_oracle_test.hpp"
#include "wend/planner/costs/leap_engine.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

using test::units_from;
using test::units_of;

Cell random_cell_in(int width, int height, Random& random) {
  const int x = random.between(0, width - 1);
  return {x, random.between(0, height - 1)};
}

/// Rooms with doors, on ground of any kind.
FreeSpace random_house(Random& random) {
  const int room = random.between(5, 12);
  const int width = random.between(20, 60);
  const int height = random.between(20, 60);
  Grid<CellState> states(width, height, CellState::free);
  Grid<double> terrain(width, height, 1);
  const auto ground = static_cast<test::Ground>(random.between(0, 5));
  const double blocked = random.chance(0.5) ? 0 : 0.1 * random.uniform();
  for (const Cell cell : every_cell(states)) {
    terrain[cell] = test::multiplier_on(ground, random);
    const bool wall = cell.x % room == room - 1 || cell.y % room == room - 1;
    if (wall || random.chance(blocked)) states[cell] = CellState::occupied;
  }
  for (int doors = width * height / (room * room); doors > 0; --doors) {
    const Cell corner = random_cell_in(width, height, random);
    const int wide = random.between(1, 5);
    const bool across = random.chance(0.5);
    for (int i = 0; i < wide; ++i) {
      const Cell cell{corner.x + (across ? i : 0), corner.y + (across ? 0 : i)};
      if (cell.x < width && cell.y < height) states[cell] = CellState::free;
    }
  }
  if (ground == test::Ground::rectangles) test::add_rectangles(terrain, random);
  FreeSpaceOptions options;
  if (ground == test::Ground::inflated) {
    options.clearance_distance = 5 * random.uniform();
    options.clearance_cost = 8 * random.uniform();
  }
  return *make_free_space(*make_grid_map(states, {}, terrain), options);
}

FreeSpace random_space(Random& random) {
  return random.chance(0.7) ? random_house(random) : test::random_cost_space(random);
}

Cell free_cell_of(const FreeSpace& space, Random& random) {
  for (;;) {
    const Cell cell = test::random_cell_of(space, random);
    if (space.passable(cell)) return cell;
  }
}

/// The space in which the first cells of closed rooms are blocked.
FreeSpace without_closed(const FreeSpace& space, const CostGrid<std::uint64_t>& grid,
                         const SideRooms& rooms) {
  Grid<CellState> states(space.width(), space.height());
  Grid<double> terrain(space.width(), space.height(), 1);
  for (const Cell cell : every_cell(states)) {
    const bool free = space.passable(cell) && !rooms.closed(grid.number(cell));
    states[cell] = free ? CellState::free : CellState::occupied;
    if (free) terrain[cell] = space.costs().steps(cell) / static_cast<double>(CostMap::kOne);
  }
  return *make_free_space(*make_grid_map(states, {}, terrain));
}

TEST(SideRooms, LieOnNoCheapestPathToElsewhere) {
  std::size_t closed = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(2000U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = random_space(random);
    if (space.uniform_terrain() || space.passable().count() < 2) continue;
    const CostGrid<std::uint64_t> grid(space, {});
    SideRooms rooms(grid);
    for (int query = 0; query < 3; ++query) {
      const Cell start = free_cell_of(space, random);
      const GoalRegion goal(free_cell_of(space, random));
      rooms.close_for(start, {&goal, 1});
      const FreeSpace rest = without_closed(space, grid, rooms);
      closed += space.passable().count() - rest.passable().count();
      const std::size_t at = static_cast<std::size_t>(goal.any().y * space.width() + goal.any().x);
      const GridMoves moves{random.chance(0.5) ? Connectivity::four : Connectivity::eight,
                            static_cast<CornerRule>(random.between(0, 2))};
      if (rest.uniform_terrain()) continue;
      ASSERT_EQ(units_from(space, moves, start)[at], units_from(rest, moves, start)[at]);
    }
  }
  EXPECT_GT(closed, test::share_of(2000U));
}

/// Enough queries for rooms to be closed, and edits between them.
TEST(SideRooms, DoNotChangeTheCostsOfSearches) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(test::share_of(2000U)) && !HasFailure();
       ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    FreeSpace space = random_space(random);
    if (space.uniform_terrain()) continue;
    const Connectivity connectivity = random.chance(0.2) ? Connectivity::four : Connectivity::eight;
    const BestFirst parts{{connectivity, static_cast<CornerRule>(random.between(0, 2))},
                          resolved(HeuristicKind::automatic, connectivity),
                          0,
                          1};
    if (!can_leap(space, parts)) continue;
    GridPlanner::Parts made = leap_parts(space, parts, random.chance(0.2) ? 3 : 0);
    for (int query = 0; query < 12 && space.passable().count() > 0; ++query) {
      const Cell start = free_cell_of(space, random);
      const GoalRegion goal(free_cell_of(space, random));
      const std::uint64_t least =
          units_from(space, parts.moves,
                     start)[static_cast<std::size_t>(goal.any().y * space.width() + goal.any().x)];
      const Limits limits;
      made.engine->begin(start, {&goal, 1}, limits, nullptr);
      const SearchOutcome outcome = made.engine->run();
      ASSERT_EQ(outcome == SearchOutcome::found, least != test::kNoUnits);
      if (outcome == SearchOutcome::found) {
        Path path;
        made.engine->write_path(path);
        ASSERT_TRUE(check_grid_path(space, parts.moves, path.cells()));
        ASSERT_EQ(units_of(space, path.cells()), least);
        ++found;
      }
      if (!random.chance(0.3)) continue;
      const auto change = space.edit(test::random_edit(random, space.map(), true));
      ASSERT_TRUE(change);
      if (change->everything || space.uniform_terrain()) break;
      made = made.repaired(space, *change);
    }
  }
  EXPECT_GT(found, test::share_of(test::share_of(6000)));
}

/// In an office most rooms are left out from the second query on.
TEST(SideRooms, SaveAnOfficeHalfOfItsExpansions) {
  const FreeSpace space =
      *make_free_space(*make_map("office", 600, 450, 7),
                       {.footprint = Footprint::disc(0.3), .clearance_distance = 0.5});
  const auto engine = leap_parts(space, {{}, HeuristicKind::octile, 0, 1}).engine;
  const GoalRegion goal(Cell{580, 430});
  const Limits limits;
  std::vector<std::uint64_t> expanded;
  for (int query = 0; query < 4; ++query) {
    engine->begin({12, 12}, {&goal, 1}, limits, nullptr);
    ASSERT_EQ(engine->run(), SearchOutcome::found);
    expanded.push_back(engine->metrics().expanded);
  }
  EXPECT_LT(2 * expanded.back(), expanded.front());
}

}  // namespace
}  // namespace wend
