#include "wend/map/map_edit.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "conformance/random_edit.hpp"
#include "tests/testing/share.hpp"
#include "wend/map/obstacles.hpp"

namespace wend {
namespace {

bool inside_any(const std::vector<CellBox>& boxes, Cell cell) {
  return std::ranges::any_of(boxes, [&](const CellBox& box) { return box.contains(cell); });
}

void expect_equal(const GridMap& map, const GridMap& expected) {
  EXPECT_TRUE(map.occupied() == expected.occupied());
  EXPECT_TRUE(map.unknown() == expected.unknown());
  EXPECT_EQ(map.uniform_terrain(), expected.uniform_terrain());
  EXPECT_TRUE(map.terrain() == expected.terrain());
  EXPECT_EQ(map.frame(), expected.frame());
}

TEST(MapEdit, MakesTheMapThatIsMadeCellByCell) {
  for (std::uint64_t seed = 0; seed < test::share_of(400U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    GridMap map = test::random_map(random);
    for (int i = 0; i < 5; ++i) {
      const MapEdit edit = test::random_edit(random, map, true);
      const GridMap before = map;
      const GridMap before_by_value =
          *make_grid_map(map.occupied(), map.unknown(), map.frame(), map.terrain());
      const GridMap expected = test::edited_by_hand(map, edit);
      const auto boxes = map.edit(edit);
      ASSERT_TRUE(boxes) << boxes.error().message;
      expect_equal(map, expected);
      expect_equal(before, before_by_value);
      for (const CellBox& box : *boxes) ASSERT_FALSE(box.empty());
      for (const Cell cell : every_cell(map)) {
        const bool differs =
            map.state(cell) != before.state(cell) || map.terrain(cell) != before.terrain(cell);
        ASSERT_TRUE(!differs || inside_any(*boxes, cell)) << cell.x << "," << cell.y;
      }
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(MapEdit, ReturnsTheLeastBoxOfWhatDiffers) {
  GridMap map = *make_grid_map(Grid<CellState>(200, 100, CellState::free));
  Grid<CellState> states(150, 80, CellState::free);
  states[{20, 30}] = CellState::occupied;
  states[{100, 31}] = CellState::unknown;
  const MapEdit edit{.corner = {10, 5}, .states = states};
  EXPECT_EQ(*map.edit(edit), (std::vector<CellBox>{{{30, 35}, {111, 37}}}));
  EXPECT_TRUE(map.edit(edit)->empty()) << "nothing differs any more";
}

TEST(MapEdit, IsDoneInPlaceWhereNobodySharesTheCells) {
  GridMap map = *make_grid_map(Grid<CellState>(9, 9, CellState::free));
  const BitGrid* const place = &map.occupied();
  ASSERT_TRUE(map.edit({.cells = {{{3, 4}, CellState::occupied}}}));
  EXPECT_EQ(&map.occupied(), place);
  EXPECT_EQ(map.state({3, 4}), CellState::occupied);
}

TEST(MapEdit, IsRefusedWhereItDoesNotFit) {
  GridMap map = *make_grid_map(Grid<CellState>(10, 8, CellState::free));
  const Grid<CellState> door(3, 2, CellState::occupied);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<MapEdit, std::string>> cases{
      {{.corner = {-1, 0}, .states = door},
       "cell (-1,0) of the edit is not on the map of 10 x 8 cells"},
      {{.corner = {7, 7}, .states = door},
       "cell (9,8) of the edit is not on the map of 10 x 8 cells"},
      {{.corner = {std::numeric_limits<int>::max(), 0}, .states = door},
       "cell (1073741824,0) of the edit is not on the map of 10 x 8 cells"},
      {{.corner = {0, 0}, .states = door, .terrain = Grid<double>(2, 3, 1)},
       "the states and the terrain of the edit differ in size"},
      {{.corner = {4, 4}, .terrain = Grid<double>(2, 1, 0.5)},
       "the terrain of cell (4,4) of the edit is 0.5: a multiplier is at least 1 and finite"},
      {{.cells = {{{0, 0}, CellState::occupied}, {{0, 8}, CellState::free}}},
       "cell (0,8) of the edit is not on the map of 10 x 8 cells"},
      {{.cells = {{{1, 1}, CellState::free, nan}}},
       "the terrain of cell (1,1) of the edit is nan: a multiplier is at least 1 and finite"},
  };
  for (const auto& [edit, message] : cases) {
    const auto done = map.edit(edit);
    ASSERT_FALSE(done) << message;
    EXPECT_EQ(done.error().message, message);
    EXPECT_EQ(done.error().status, Status::invalid_map);
    EXPECT_EQ(map.occupied().count() + map.unknown().count(), 0U);
  }
}

TEST(MapEdit, GathersCellsInFewBoxes) {
  for (std::uint64_t seed = 0; seed < test::share_of(200U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    std::vector<Cell> cells;
    for (int i = random.between(0, 60); i > 0; --i) {
      cells.push_back(test::random_cell(random, 1000, 1000));
    }
    const auto boxes = boxes_around(cells);
    ASSERT_LE(boxes.size(), cells.size());
    std::int64_t area = 0;
    for (const CellBox& box : boxes) area += box.size();
    for (const Cell cell : cells) ASSERT_TRUE(inside_any(boxes, cell));
    ASSERT_LE(area, static_cast<std::int64_t>(cells.size()) * 2048);
  }
  EXPECT_EQ(boxes_around({{1, 1}, {3, 2}, {900, 900}}).size(), 2U);
  EXPECT_EQ(boxes_around({{1, 1}, {1, 33}, {33, 2}}).size(), 1U) << "near squares share a box";
}

TEST(MapEdit, ChangesObstaclesAsMakingThemAnewDoes) {
  for (std::uint64_t seed = 0; seed < test::share_of(200U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const GridMap map = test::random_map(random);
    const bool unknown_is_free = random.chance(0.5);
    const ObstacleOptions options{
        .unknown = unknown_is_free ? UnknownPolicy::free : UnknownPolicy::blocked,
        .outside = test::random_outside(random)};
    Obstacles obstacles(map, options);
    for (int i = 0; i < 4; ++i) {
      if (random.chance(0.5)) obstacles.squared_half_cell_clearance();
      ASSERT_TRUE(obstacles.edit(test::random_edit(random, obstacles.map(), false)));
      const Obstacles expected(obstacles.map(), options);
      ASSERT_TRUE(obstacles.blocked() == expected.blocked());
      for (const Cell cell : every_cell(map)) {
        ASSERT_EQ(obstacles.clearance(cell), expected.clearance(cell));
      }
      ASSERT_TRUE(obstacles.squared_half_cell_clearance() ==
                  expected.squared_half_cell_clearance());
    }
  }
}

}  // namespace
}  // namespace wend
