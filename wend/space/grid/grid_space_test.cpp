#include "wend/space/grid/grid_space.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/share.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;

struct Successor {
  Cell cell;
  Move move;
  double cost;  // in cells
};

template <class Space>
std::vector<Successor> successors(const Space& space, Cell from, Move arrival = kNoMove) {
  std::vector<Successor> found;
  space.for_each_successor(
      space.state(from), arrival, [&](const GridState& next, Move move, auto cost) {
        EXPECT_EQ(next.number, space.state(next.cell).number);
        found.push_back({next.cell, move, static_cast<double>(cost) / Space::kUnitsPerCell});
      });
  return found;
}

template <class Space>
std::vector<Cell> cells_after(const Space& space, Cell from) {
  std::vector<Cell> cells;
  for (const Successor& successor : successors(space, from)) cells.push_back(successor.cell);
  return cells;
}

FreeSpace open_space(bool y_up) {
  Frame frame;
  frame.y_up = y_up;
  return *make_free_space(*make_grid_map(Grid<CellState>(3, 3, CellState::free), frame));
}

// Because of this fixed order, expansion orders are the same everywhere.

TEST(GridSpace, ListsSuccessorsInTheOrderOfDirection) {
  for (const bool y_up : {false, true}) {
    EXPECT_THAT(cells_after(ExactGrid(open_space(y_up)), {1, 1}),
                ElementsAre(Cell{1, 2}, Cell{2, 2}, Cell{2, 1}, Cell{2, 0}, Cell{1, 0}, Cell{0, 0},
                            Cell{0, 1}, Cell{0, 2}))
        << "y_up " << y_up;
  }
}

TEST(GridSpace, ListsFourNeighboursInTheSameOrder) {
  const ExactGrid grid(open_space(false), {Connectivity::four, CornerRule::both});
  EXPECT_THAT(cells_after(grid, {1, 1}),
              ElementsAre(Cell{1, 2}, Cell{2, 1}, Cell{1, 0}, Cell{0, 1}));
}

TEST(GridSpace, NumbersCellsRowByRow) {
  const ExactGrid grid(*make_free_space(*make_grid_map(Grid<CellState>(7, 4, CellState::free))));
  EXPECT_EQ(grid.state_count(), 28U);
  for (StateId id = 0; id < 28; ++id) {
    const Cell cell{static_cast<int>(id) % 7, static_cast<int>(id) / 7};
    EXPECT_EQ(grid.state(id).cell, cell);
    EXPECT_EQ(grid.state(cell).number, id);
    EXPECT_EQ(grid.id(grid.state(id)), id);
  }
}

/// Runs a check for random maps, robots and rules, together with a reference of the same problem.
template <class Check>
void on_random_spaces(int count, Check&& check) {
  for (int seed = 1; seed <= test::share_of(count) && !::testing::Test::HasFailure(); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map = test::random_map(random);
    const FreeSpaceOptions robot = test::random_robot(random, map.frame().resolution);
    const int corners = random.between(0, 2);
    const bool diagonals = random.chance(0.8);
    const test::Reference reference(map, test::robot_in_cells(robot, map.frame()),
                                    {diagonals, corners});
    SCOPED_TRACE("seed " + std::to_string(seed) + ", radius " +
                 std::to_string(robot.footprint.circumscribed_radius() / map.frame().resolution) +
                 ", corners cut " + std::to_string(corners) + "\n" + test::drawing_of(map));
    check(*make_free_space(map, robot),
          GridMoves{diagonals ? Connectivity::eight : Connectivity::four,
                    static_cast<CornerRule>(corners)},
          reference);
  }
}

template <class Visit>
void for_passable_cells(const FreeSpace& space, Visit&& visit) {
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      if (space.passable({x, y})) visit(Cell{x, y});
    }
  }
}

TEST(GridSpace, HasTheStepsThatTheReferenceHas) {
  on_random_spaces(
      500, [](const FreeSpace& space, GridMoves moves, const test::Reference& reference) {
        const ExactGrid grid(space, moves);
        for_passable_cells(space, [&](Cell from) {
          const std::vector<Cell> reached = cells_after(grid, from);
          for (int dy = -2; dy <= 2; ++dy) {
            for (int dx = -2; dx <= 2; ++dx) {
              const Cell to{from.x + dx, from.y + dy};
              const bool expected = reference.is_step(from, to);
              ASSERT_EQ(std::count(reached.begin(), reached.end(), to), expected ? 1 : 0);
              ASSERT_EQ(grid.is_step(from, to), expected);
            }
          }
        });
      });
}

/// Without obstacles a robot of any size may cut corners.
TEST(GridSpace, LetsAVastDiscCutCorners) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(4, 4, CellState::free)),
                                           {.footprint = Footprint::disc(1e9)});
  EXPECT_TRUE(ExactGrid(space, {Connectivity::eight, CornerRule::both}).is_step({1, 1}, {2, 2}));
}

TEST(GridSpace, ChargesWhatTheReferenceCharges) {
  on_random_spaces(
      300, [](const FreeSpace& space, GridMoves moves, const test::Reference& reference) {
        const ExactGrid exact(space, moves);
        const TerrainGrid rough(space, moves);
        for_passable_cells(space, [&](Cell from) {
          const auto reached =
              space.uniform_terrain() ? successors(exact, from) : successors(rough, from);
          for (const Successor& successor : reached) {
            const double expected = reference.step_cost(from, successor.cell);
            const double excess = space.uniform_terrain() ? 1e-11 : CostUnits::kMostExcess;
            ASSERT_GE(successor.cost, expected * (1 - 1e-11));
            ASSERT_LE(successor.cost, expected * (1 + excess));
          }
        });
      });
}

TEST(GridSpace, ChargesCompactUnitsWithin32Bits) {
  const FreeSpace space = open_space(false);
  for (const Successor& successor : successors(CompactGrid(space), {1, 1})) {
    const bool diagonal = successor.cell.x != 1 && successor.cell.y != 1;
    EXPECT_NEAR(successor.cost, diagonal ? std::numbers::sqrt2 : 1, 1e-9);
  }
}

TEST(GridSpace, UndoesEveryMove) {
  on_random_spaces(100, [](const FreeSpace& space, GridMoves moves, const test::Reference&) {
    const ExactGrid grid(space, moves);
    for_passable_cells(space, [&](Cell from) {
      for (const Successor& successor : successors(grid, from)) {
        const GridState parent = grid.parent(grid.state(successor.cell), successor.move);
        ASSERT_EQ(parent.cell, from);
        ASSERT_EQ(parent.number, grid.state(from).number);
      }
    });
  });
}

TEST(GridSpace, HasNoStepFromOrToABlockedCellOrOutside) {
  Grid<CellState> states(3, 1, CellState::free);
  states[{1, 0}] = CellState::occupied;
  const ExactGrid grid{*make_free_space(*make_grid_map(states))};
  EXPECT_FALSE(grid.is_step({0, 0}, {1, 0}));
  EXPECT_FALSE(grid.is_step({1, 0}, {2, 0}));
  EXPECT_FALSE(grid.is_step({0, 0}, {-1, 0}));
  EXPECT_FALSE(grid.is_step({-1, 0}, {0, 0}));
  EXPECT_FALSE(grid.is_step({0, 0}, {0, 0}));
  EXPECT_FALSE(grid.is_step({0, 0}, {2, 0}));
}

/// A space keeps what it needs: the FreeSpace that it was made of may be destroyed, and copies are
/// complete.
TEST(GridSpace, OutlivesTheFreeSpaceItWasMadeOf) {
  Grid<double> terrain(3, 1, 1);
  terrain[{1, 0}] = 3;
  const GridMap map = *make_grid_map(Grid<CellState>(3, 1, CellState::free), {}, terrain);
  auto first = std::make_unique<TerrainGrid>(*make_free_space(map));
  const TerrainGrid copy = *first;
  first.reset();
  EXPECT_EQ(successors(copy, {0, 0}).front().cost, 2);
  EXPECT_THAT(cells_after(copy, {1, 0}), ElementsAre(Cell{2, 0}, Cell{0, 0}));
}

}  // namespace
}  // namespace wend
