// What a laser scanner sees, against straight lines that keep clear of obstacles, or that hardly cut them.

#include "wend_ros/sensed_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace wend_ros {
namespace {

using wend::Cell;
using wend::CellState;
using wend::GridMap;
using wend::Point;

constexpr int kSide = 24;
constexpr double kRange = 9;

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
  return *wend::make_grid_map(cells, {.resolution = 0.5, .y_up = true, .metric = true});
}

/// Does a line pass an occupied cell other than `but`, grown by a margin on each side (negative: shrunk)?
bool passes_obstacle(const GridMap& map, Point from, Point to, Cell but, double margin) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const int steps = 1 + static_cast<int>(length / 0.02);
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Point at{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
    for (int y = static_cast<int>(at.y) - 1; y <= static_cast<int>(at.y) + 1; ++y) {
      for (int x = static_cast<int>(at.x) - 1; x <= static_cast<int>(at.x) + 1; ++x) {
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

/// Can a point of the cell be seen, if obstacles are a little smaller than they are?
bool may_be_seen(const GridMap& map, Point from, Cell cell) {
  constexpr int kPoints = 12;
  for (int j = 0; j <= kPoints; ++j) {
    for (int i = 0; i <= kPoints; ++i) {
      const Point to{cell.x + static_cast<double>(i) / kPoints,
                     cell.y + static_cast<double>(j) / kPoints};
      if (!passes_obstacle(map, from, to, cell, -0.2)) return true;
    }
  }
  return false;
}

TEST(SeenCells, AreThoseThatStraightLinesReach) {
  std::mt19937 random(3);
  int seen_ones = 0;
  int hidden = 0;
  for (int n = 0; n < 60; ++n) {
    const GridMap map = random_map(random);
    const Point from{std::uniform_real_distribution<double>(0, kSide)(random),
                     std::uniform_real_distribution<double>(0, kSide)(random)};
    const Cell here{static_cast<int>(from.x), static_cast<int>(from.y)};
    if (map.state(here) == CellState::occupied) continue;
    std::set<std::pair<int, int>> seen;
    for (const Cell cell : seen_cells(map, from, kRange)) seen.insert({cell.x, cell.y});
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const Point middle = wend::centre_of({x, y});
        const double distance = std::hypot(middle.x - from.x, middle.y - from.y);
        const bool is_seen = seen.contains({x, y});
        seen_ones += is_seen ? 1 : 0;
        if (is_seen) {
          ASSERT_LT(distance, kRange + 0.75) << x << ',' << y;
          ASSERT_TRUE(may_be_seen(map, from, {x, y})) << n << ": " << x << ',' << y;
        } else if (distance < kRange - 0.75) {
          ASSERT_TRUE(passes_obstacle(map, from, middle, {x, y}, 0.3))
              << n << ": " << x << ',' << y;
          ++hidden;
        }
      }
    }
  }
  EXPECT_GT(seen_ones, 1000);
  EXPECT_GT(hidden, 1000);
}

TEST(SeenCells, NoneFromOutsideOfTheMap) {
  const GridMap map = *wend::make_grid_map(wend::Grid<CellState>(5, 5, CellState::free));
  EXPECT_TRUE(seen_cells(map, {-0.5, 2}, 9).empty());
  EXPECT_TRUE(seen_cells(map, {2, 5}, 9).empty());
  EXPECT_TRUE(seen_cells(map, {std::nan(""), 2}, 9).empty());
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
    const wend::MapPose robot{std::uniform_real_distribution<double>(0, kSide / 2.0)(random),
                              std::uniform_real_distribution<double>(0, kSide / 2.0)(random), 0};
    const wend::CellBox changed = sensed->look(robot.point(), 4);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const Cell cell{x, y};
        const CellState now = sensed->known().state(cell);
        ASSERT_TRUE(now == truth.state(cell) || now == CellState::unknown);
        if (now != before.state(cell)) ASSERT_TRUE(changed.contains(cell));
      }
    }
    ASSERT_TRUE(sensed->look(robot.point(), 4).empty()) << "there is no more to see";
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
