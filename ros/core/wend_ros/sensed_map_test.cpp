// A robot that discovers a map: what it knows, against what wend::append_visible_cells() sees in grid coordinates.

#include "wend_ros/sensed_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "wend/explore/visible_cells.hpp"

namespace wend_ros {
namespace {

using wend::Cell;
using wend::CellState;
using wend::GridMap;
using wend::Point;

constexpr int kSide = 24;
constexpr double kRange = 9;  // cells

/// A tenth of the cells occupied, a few unknown.
GridMap random_map(std::mt19937& random) {
  wend::Grid<CellState> cells(kSide, kSide, CellState::free);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const auto drawn = random() % 40;
      if (drawn < 4) cells[{x, y}] = CellState::occupied;
      if (drawn == 5) cells[{x, y}] = CellState::unknown;
    }
  }
  return *wend::make_grid_map(
      cells, {.resolution = 0.5, .origin = {-3, 7, 0.4}, .y_up = true, .metric = true});
}

/// A point of the map in grid coordinates.
Point random_place(std::mt19937& random) {
  const double x = std::uniform_real_distribution<double>(0, kSide)(random);
  const double y = std::uniform_real_distribution<double>(0, kSide)(random);
  return {x, y};
}

/// The cells of a map that are known.
std::set<std::pair<int, int>> known_cells(const GridMap& map) {
  std::set<std::pair<int, int>> known;
  for (const Cell cell : wend::every_cell(map)) {
    if (map.state(cell) != CellState::unknown) known.insert({cell.x, cell.y});
  }
  return known;
}

/// From where it stands in a cell, in metres of a map whose origin lies elsewhere; unknown cells hide nothing.
TEST(SensedMap, KnowsWhatIsSeenFromTheRobot) {
  std::mt19937 random(3);
  std::size_t seen_ones = 0;
  for (int n = 0; n < 60; ++n) {
    const GridMap truth = random_map(random);
    const Point robot = random_place(random);
    const wend::Obstacles obstacles(truth, {.unknown = wend::UnknownPolicy::free});
    std::vector<Cell> visible;
    wend::append_visible_cells(obstacles, robot, kRange, visible);
    std::set<std::pair<int, int>> expected;
    for (const Cell cell : visible) {
      if (truth.state(cell) != CellState::unknown) expected.insert({cell.x, cell.y});
    }
    auto sensed = SensedMap::make(truth);
    ASSERT_TRUE(sensed);
    sensed->look(truth.frame().to_metres(robot), kRange * truth.frame().resolution);
    ASSERT_EQ(known_cells(sensed->known()), expected) << n;
    seen_ones += expected.size();
  }
  EXPECT_GT(seen_ones, 1000U);
}

TEST(SensedMap, LearnsNothingFromOutsideOfTheMap) {
  auto sensed = SensedMap::make(*wend::make_grid_map(wend::Grid<CellState>(5, 5, CellState::free)));
  ASSERT_TRUE(sensed);
  for (const wend::MapPoint outside :
       {wend::MapPoint{-0.5, 2}, wend::MapPoint{2, 5}, wend::MapPoint{std::nan(""), 2}}) {
    EXPECT_TRUE(sensed->look(outside, 9).empty());
  }
  EXPECT_TRUE(known_cells(sensed->known()).empty());
}

TEST(SensedMap, KnowsNothingAtFirstAndInTheEndWhatItHasSeen) {
  std::mt19937 random(5);
  const GridMap truth = random_map(random);
  auto sensed = SensedMap::make(truth);
  ASSERT_TRUE(sensed);
  const auto unknown_cells = [&] { return sensed->known().unknown().count(); };
  EXPECT_EQ(unknown_cells(), truth.size());
  for (int step = 0; step < 30; ++step) {
    const GridMap before = sensed->known();
    const wend::MapPoint robot = truth.frame().to_metres(random_place(random));
    const wend::CellBox changed = sensed->look(robot, 4);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const Cell cell{x, y};
        const CellState now = sensed->known().state(cell);
        ASSERT_TRUE(now == truth.state(cell) || now == CellState::unknown);
        ASSERT_TRUE(now == before.state(cell) || changed.contains(cell));
      }
    }
    ASSERT_TRUE(sensed->look(robot, 4).empty()) << "there is no more to see";
  }
  EXPECT_LT(unknown_cells(), truth.size() / 4);
}

TEST(SensedMap, MendsAnOldMap) {
  wend::Grid<CellState> cells(9, 9, CellState::free);
  const GridMap truth = *wend::make_grid_map(cells);
  cells[{4, 4}] = CellState::occupied;
  auto sensed = SensedMap::make(truth, *wend::make_grid_map(cells));
  ASSERT_TRUE(sensed);
  EXPECT_EQ(sensed->look({1.5, 1.5}, 2), wend::CellBox{}) << "that is as it was";
  EXPECT_EQ(sensed->look({1.5, 1.5}, 5), (wend::CellBox{{4, 4}, {5, 5}}));
  EXPECT_EQ(sensed->known().state({4, 4}), CellState::free);
}

TEST(SensedMap, RefusesAnOldMapOfAnotherPlace) {
  const wend::Grid<CellState> cells(9, 9, CellState::free);
  const GridMap truth = *wend::make_grid_map(cells);
  const auto larger =
      SensedMap::make(truth, *wend::make_grid_map(wend::Grid<CellState>(9, 10, CellState::free)));
  ASSERT_FALSE(larger);
  EXPECT_EQ(larger.error().message, "the known map has 9 x 10 cells, and the true one 9 x 9 cells");
  const auto finer = SensedMap::make(truth, *wend::make_grid_map(cells, {.resolution = 0.5}));
  ASSERT_FALSE(finer);
  EXPECT_EQ(finer.error().message,
            "the known map has another origin or resolution than the true one");
}

}  // namespace
}  // namespace wend_ros
