// What a laser scanner sees: against straight lines that are sampled, connected components, and mirrored maps.

#include "wend/explore/visible_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"

namespace wend {
namespace {

using SeenSet = std::set<std::pair<int, int>>;

/// Of a map whose unknown cells hide nothing. Fails if a cell is appended twice.
SeenSet seen_from(const GridMap& map, Point from, double range) {
  std::vector<Cell> cells;
  append_visible_cells(Obstacles(map, {.unknown = UnknownPolicy::free}), from, range, cells);
  SeenSet seen;
  for (const Cell cell : cells) seen.emplace(cell.x, cell.y);
  EXPECT_EQ(seen.size(), cells.size()) << "a cell is appended twice";
  return seen;
}

GridMap cluttered_map(Random& random, int width, int height, double blocked) {
  Grid<CellState> states(width, height, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(0.03)) states[cell] = CellState::unknown;
    if (random.chance(blocked)) states[cell] = CellState::occupied;
  }
  return *make_grid_map(states);
}

Point random_point(Random& random, const GridMap& map) {
  return {map.width() * random.uniform(), map.height() * random.uniform()};
}

double distance_to_centre(Point from, Cell cell) {
  const Point middle = centre_of(cell);
  return std::hypot(middle.x - from.x, middle.y - from.y);
}

/// Does a line pass an occupied cell other than `but`, grown by a margin on each side (negative: shrunk)?
bool passes_obstacle(const GridMap& map, Point from, Point to, Cell but, double margin) {
  const int steps = 1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / 0.02);
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Point at{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
    const Cell middle = cell_at(at);
    for (int y = middle.y - 1; y <= middle.y + 1; ++y) {
      for (int x = middle.x - 1; x <= middle.x + 1; ++x) {
        const Cell cell{x, y};
        if (cell == but || !map.contains(cell) || map.state(cell) != CellState::occupied) continue;
        if (at.x > x - margin && at.x < x + 1 + margin && at.y > y - margin &&
            at.y < y + 1 + margin) {
          return true;
        }
      }
    }
  }
  return false;
}

/// Does a line lead to a point of the cell, if obstacles are a little smaller than they are?
bool may_be_seen(const GridMap& map, Point from, Cell cell) {
  constexpr int kPoints = 12;
  for (int j = 0; j <= kPoints; ++j) {
    for (int i = 0; i <= kPoints; ++i) {
      const Point to{cell.x + static_cast<double>(i) / kPoints,
                     cell.y + static_cast<double>(j) / kPoints};
      if (!passes_obstacle(map, from, to, cell, -0.1)) return true;
    }
  }
  return false;
}

TEST(VisibleCells, AreThoseThatStraightLinesReach) {
  constexpr double kBetweenRays = 0.26;  // half of the gap between their ends, and a little
  int seen_ones = 0;
  int hidden = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(150U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double blocked = 0.3 * random.uniform();
    const double range = 3 + 15 * random.uniform();
    const GridMap map = cluttered_map(random, 24, 24, blocked);
    const Point from = random_point(random, map);
    if (map.state(cell_at(from)) == CellState::occupied) continue;
    const SeenSet seen = seen_from(map, from, range);
    for (const Cell cell : every_cell(map)) {
      if (seen.contains({cell.x, cell.y})) {
        EXPECT_TRUE(cell == cell_at(from) || distance_to_centre(from, cell) <= range);
        EXPECT_TRUE(may_be_seen(map, from, cell)) << cell.x << ',' << cell.y;
        ++seen_ones;
      } else if (distance_to_centre(from, cell) <= range) {
        EXPECT_TRUE(passes_obstacle(map, from, centre_of(cell), cell, kBetweenRays))
            << cell.x << ',' << cell.y;
        ++hidden;
      }
    }
  }
  EXPECT_GT(seen_ones, test::share_of(1000));
  EXPECT_GT(hidden, test::share_of(1000));
}

TEST(VisibleCells, AreThoseInRangeWhereNothingStandsInTheWay) {
  const GridMap map = test::open_space(40, 30).map();
  Random random(1);
  std::vector<Point> places{{12.5, 11.5}, {12, 11}, {0, 0}, {12.5, 11}};
  for (int i = 0; i < 20; ++i) places.push_back(random_point(random, map));
  for (const Point from : places) {
    for (const double range : {0.0, 0.4, 1.0, 1.5, 3.0, 7.3, 100.0}) {
      const SeenSet seen = seen_from(map, from, range);
      for (const Cell cell : every_cell(map)) {
        const bool near = cell == cell_at(from) || distance_to_centre(from, cell) <= range;
        EXPECT_EQ(seen.contains({cell.x, cell.y}), near)
            << cell.x << ',' << cell.y << " in " << range << " of " << from.x << ',' << from.y;
      }
    }
  }
}

/// A wall hides what is behind it, even one whose cells touch at corners only.
TEST(VisibleCells, AreInTheSameRoomOrItsWall) {
  int stopped = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(400U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const GridMap map = cluttered_map(random, 30, 20, 0.4);
    const bool in_the_middle = random.chance(0.5);
    Point from = random_point(random, map);
    if (in_the_middle) from = centre_of(cell_at(from));
    if (map.state(cell_at(from)) == CellState::occupied) continue;
    const FreeSpace space = *make_free_space(map, {.unknown = UnknownPolicy::free});
    for (const auto& [x, y] : seen_from(map, from, 100)) {
      const bool wall = map.state({x, y}) == CellState::occupied;
      stopped += wall ? 1 : 0;
      EXPECT_TRUE(wall || space.components().connected(cell_at(from), {x, y}, Adjacency::edges))
          << x << ',' << y;
    }
  }
  EXPECT_GT(stopped, test::share_of(1000));
}

/// No direction is preferred, not even by rounding, from points that sixteenths of a cell describe exactly.
TEST(VisibleCells, OfAMirroredMapAreMirrored) {
  for (std::uint64_t seed = 1; seed <= test::share_of(200U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const GridMap map = cluttered_map(random, 33, 21, 0.15);
    const bool in_the_middle = random.chance(0.3);
    Point from = centre_of(cell_at(random_point(random, map)));
    if (!in_the_middle) {
      from.x += (2 * random.between(-4, 3) + 1) / 16.0;
      from.y += (2 * random.between(-4, 3) + 1) / 16.0;
    }
    const auto is_same = [&](int width, int height, auto moved) {
      Grid<CellState> states(width, height, CellState::free);
      for (const Cell cell : every_cell(map)) {
        states[cell_at(moved(centre_of(cell)))] = map.state(cell);
      }
      SeenSet expected;
      for (const auto& [x, y] : seen_from(map, from, 12)) {
        const Cell to = cell_at(moved(centre_of({x, y})));
        expected.emplace(to.x, to.y);
      }
      return seen_from(*make_grid_map(states), moved(from), 12) == expected;
    };
    EXPECT_TRUE(is_same(33, 21, [](Point at) { return Point{33 - at.x, at.y}; }));
    EXPECT_TRUE(is_same(33, 21, [](Point at) { return Point{at.x, 21 - at.y}; }));
    EXPECT_TRUE(is_same(21, 33, [](Point at) { return Point{at.y, at.x}; }));
  }
}

TEST(VisibleCells, EndAtAWallWhichIsSeen) {
  const GridMap map = test::drawn_map(
      ".........\n"
      "....#....\n"
      "....#....\n"
      "....#....\n"
      ".........\n");
  const SeenSet seen = seen_from(map, {2.5, 2.5}, 20);
  EXPECT_TRUE(seen.contains({4, 2}));
  EXPECT_TRUE(seen.contains({4, 1}));
  for (int x = 5; x < 9; ++x) EXPECT_FALSE(seen.contains({x, 2})) << x;
}

/// The slit that leads to the cell is 0.67 cells wide at the ends of the rays.
TEST(VisibleCells, AreSeenThroughASlitThatIsWiderThanTheGapOfRays) {
  const GridMap map = test::drawn_map(
      ".....\n"
      ".##..\n"
      ".....\n"
      ".....\n");
  EXPECT_TRUE(seen_from(map, {0.5, 0.5}, 5).contains({1, 2}));
}

/// What a pillar hides from the middle of a cell is seen past it from the cell's edge.
TEST(VisibleCells, DependOnThePlaceInACell) {
  const GridMap map = test::drawn_map(
      ".......\n"
      ".#.....\n"
      ".......\n"
      ".......\n");
  EXPECT_FALSE(seen_from(map, {0.5, 0.5}, 20).contains({5, 3}));
  EXPECT_TRUE(seen_from(map, {0.95, 0.05}, 20).contains({5, 3}));
}

TEST(VisibleCells, OfAPointInABlockedCellAreNotHiddenByIt) {
  const GridMap map = test::drawn_map("..#..\n");
  EXPECT_EQ(seen_from(map, {2.5, 0.5}, 1).size(), 3U);
}

TEST(VisibleCells, NoneFromOutsideOfTheMap) {
  const GridMap map = test::open_space(5, 5).map();
  EXPECT_TRUE(seen_from(map, {-0.5, 2}, 9).empty());
  EXPECT_TRUE(seen_from(map, {2, 5}, 9).empty());
  EXPECT_TRUE(seen_from(map, {std::nan(""), 2}, 9).empty());
}

TEST(VisibleCells, OfAnInfiniteRangeAreAllThatNothingHides) {
  const GridMap map = test::open_space(50, 3).map();
  EXPECT_EQ(seen_from(map, {0.2, 2.9}, std::numeric_limits<double>::infinity()).size(), 150U);
}

}  // namespace
}  // namespace wend
