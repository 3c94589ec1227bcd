// An edited FreeSpace is the one that is made of the edited map, bit by bit, and the change says where it
// differs from before.

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "conformance/random_edit.hpp"
#include "tests/testing/share.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {
namespace {

constexpr Adjacency kAdjacencies[] = {Adjacency::edges, Adjacency::edges_and_corners};

Footprint random_footprint(Random& random, double resolution) {
  const double size = (0.3 + 2 * random.uniform()) * resolution;
  if (random.chance(0.7)) return Footprint::disc(random.chance(0.05) ? 70 * resolution : size);
  // The base point is inside, on the rear edge or behind it.
  const auto ahead = test::one_of<double>(random, std::array{0.25 * size, 0.75 * size, 2 * size});
  return *Footprint::rectangle(1.5 * size, size, ahead);
}

FreeSpaceOptions random_robot_of_any_shape(Random& random, double resolution) {
  FreeSpaceOptions robot = test::random_robot(random, resolution);
  if (random.chance(0.5)) robot.footprint = random_footprint(random, resolution);
  return robot;
}

void expect_equal(const FreeSpace& space, const FreeSpace& expected, bool ask_components) {
  ASSERT_TRUE(space.obstacles().blocked() == expected.obstacles().blocked());
  ASSERT_TRUE(space.passable() == expected.passable());
  ASSERT_TRUE(space.possible() == expected.possible());
  ASSERT_EQ(space.uniform_terrain(), expected.uniform_terrain());
  const auto reach = static_cast<std::uint32_t>(10'000);
  for (const Cell cell : every_cell(space.map())) {
    ASSERT_EQ(space.map().state(cell), expected.map().state(cell));
    ASSERT_EQ(space.terrain(cell), expected.terrain(cell)) << cell.x << "," << cell.y;
    ASSERT_EQ(space.squared_half_cell_clearance(cell, reach),
              expected.squared_half_cell_clearance(cell, reach))
        << cell.x << "," << cell.y;
    for (const std::uint32_t least : {1U, 2U, 9U, 50U, 400U}) {
      ASSERT_EQ(space.is_known_clear(cell, least), expected.is_known_clear(cell, least));
    }
  }
  if (!ask_components) return;
  for (const Adjacency adjacency : kAdjacencies) {
    ASSERT_EQ(space.components().sizes(adjacency), expected.components().sizes(adjacency));
    for (const Cell cell : every_cell(space.map())) {
      ASSERT_EQ(space.components().component(cell, adjacency),
                expected.components().component(cell, adjacency));
    }
  }
}

/// Outside of the boxes nothing differs that the change vouches for.
void expect_as_before(const FreeSpace& space, const FreeSpace& before, const SpaceChange& change) {
  ASSERT_FALSE(change.everything);
  for (const Cell cell : every_cell(space.map())) {
    const bool may_differ =
        std::ranges::any_of(change.boxes, [&](const CellBox& box) { return box.contains(cell); });
    if (may_differ) continue;
    ASSERT_EQ(space.obstacles().blocked()[cell], before.obstacles().blocked()[cell]);
    ASSERT_EQ(space.passable(cell), before.passable(cell));
    ASSERT_EQ(space.possible()[cell], before.possible()[cell]);
    ASSERT_EQ(space.terrain(cell), before.terrain(cell));
  }
}

void check_sequence(std::uint64_t seed, int edits) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  GridMap map = test::random_map(random);
  const FreeSpaceOptions robot = random_robot_of_any_shape(random, map.frame().resolution);
  FreeSpace space = *make_free_space(map, robot);
  for (int i = 0; i < edits; ++i) {
    if (random.chance(0.5)) space.components().count(Adjacency::edges);
    if (random.chance(0.2)) space.components().count(Adjacency::edges_and_corners);
    if (random.chance(0.2)) space.squared_half_cell_clearance();
    const MapEdit edit = test::random_edit(random, map, random.chance(0.3));
    map = test::edited_by_hand(map, edit);
    const bool shared = random.chance(0.5);
    const std::optional<FreeSpace> before = shared ? std::optional(space) : std::nullopt;
    const std::optional<FreeSpace> old =
        shared ? std::optional(*make_free_space(space.map(), robot)) : std::nullopt;
    const auto change = space.edit(edit);
    ASSERT_TRUE(change) << change.error().message;
    const FreeSpace expected = *make_free_space(map, robot);
    expect_equal(space, expected, random.chance(0.5));
    if (testing::Test::HasFatalFailure()) return;
    if (!before) continue;
    expect_equal(*before, *old, true);
    expect_as_before(space, *before, *change);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(FreeSpaceEdit, MakesTheSpaceOfTheEditedMap) {
  for (std::uint64_t seed = 0; seed < test::share_of(600U); ++seed) {
    check_sequence(seed, 5);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(FreeSpaceEdit, MakesTheSpaceOfTheEditedMapLongRun) {
  for (std::uint64_t seed = 1'000'000; seed < 1'100'000; ++seed) {
    check_sequence(seed, 3);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(FreeSpaceEdit, IsDoneInPlaceWhereNobodySharesTheSpace) {
  FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(99, 99, CellState::free)),
                                     {.footprint = Footprint::disc(3)});
  const BitGrid* const passable = &space.passable();
  const BitGrid* const occupied = &space.map().occupied();
  const auto change = space.edit({.cells = {{{50, 40}, CellState::occupied}}});
  ASSERT_TRUE(change);
  EXPECT_EQ(&space.passable(), passable);
  EXPECT_EQ(&space.map().occupied(), occupied);
  EXPECT_FALSE(space.passable({52, 40}));
  EXPECT_EQ(change->boxes.size(), 1U);
  EXPECT_LE(change->boxes.front().size(), 13 * 13) << "the cell, and 6 cells around it at most";
  EXPECT_TRUE(space.edit({.cells = {{{50, 40}, CellState::occupied}}})->none());
}

TEST(FreeSpaceEdit, LeavesOtherRobotsOnTheSameObstaclesAsTheyWere) {
  const Obstacles obstacles(*make_grid_map(Grid<CellState>(20, 20, CellState::free)));
  FreeSpace small = *make_free_space(obstacles, {.footprint = Footprint::disc(1)});
  const FreeSpace large = *make_free_space(obstacles, {.footprint = Footprint::disc(2)});
  ASSERT_TRUE(small.edit({.cells = {{{5, 5}, CellState::occupied}}}));
  EXPECT_FALSE(small.passable({5, 5}));
  EXPECT_TRUE(large.passable({5, 5}));
  EXPECT_FALSE((obstacles.blocked()[{5, 5}]));
}

TEST(FreeSpaceEdit, IsRefusedWhereItDoesNotFitAndChangesNothing) {
  FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(4, 3, CellState::free)));
  const auto refused =
      space.edit({.cells = {{{0, 0}, CellState::occupied}, {{4, 0}, CellState::occupied}}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().status, Status::invalid_map);
  EXPECT_EQ(refused.error().message, "cell (4,0) of the edit is not on the map of 4 x 3 cells");
  EXPECT_TRUE(space.passable({0, 0}));
}

}  // namespace
}  // namespace wend
