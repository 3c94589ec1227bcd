#include "wend/planner/goal_region.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/base/random.hpp"
#include "wend/planner/goal_cells.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<Cell> places_of(const GoalRegion& region) {
  std::vector<Cell> places;
  region.for_each([&](Cell place) { places.push_back(place); });
  return places;
}

/// The places within the tolerance, by looking at all of them.
std::set<Cell> brute_places(const Goal& goal, std::optional<Cell> nearest, const PlaceGrid& grid) {
  std::set<Cell> places;
  if (nearest) places.insert(*nearest);
  if (goal.tolerance == 0) return places;
  for (int x = 0; x < grid.columns; ++x) {
    for (int y = 0; y < grid.rows; ++y) {
      const double dx = grid.offset + x * grid.spacing - goal.point.x;
      const double dy = grid.offset + y * grid.spacing - goal.point.y;
      if (std::sqrt(dx * dx + dy * dy) < goal.tolerance + 1e-7) places.insert({x, y});
    }
  }
  return places;
}

TEST(GoalRegion, HasThePlacesWithinTheToleranceOfAnyPoint) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const PlaceGrid grid{.offset = random.chance(0.5) ? 0.5 : 0,
                         .spacing = random.between(1, 3),
                         .columns = random.between(1, 9),
                         .rows = random.between(1, 9)};
    const Cell place{random.between(-4, 12), random.between(-4, 12)};
    Goal goal(random.chance(0.5) ? grid.point(place)
                                 : Point{14 * random.uniform() - 3, 14 * random.uniform() - 3});
    if (random.chance(0.8))
      goal.tolerance = random.chance(0.5) ? random.between(0, 5) : 6 * random.uniform();
    std::optional<Cell> nearest;
    if (random.chance(0.7))
      nearest = Cell{random.between(0, grid.columns - 1), random.between(0, grid.rows - 1)};
    const GoalRegion region(goal, nearest, grid);

    const std::set<Cell> expected = brute_places(goal, nearest, grid);
    const std::vector<Cell> places = places_of(region);
    EXPECT_EQ(std::set<Cell>(places.begin(), places.end()), expected);
    EXPECT_EQ(places.size(), expected.size()) << "each once";
    EXPECT_EQ(region.empty(), expected.empty());
    if (nearest) {
      EXPECT_EQ(places.front(), *nearest);
    }
    for (int x = 0; x < grid.columns; ++x) {
      for (int y = 0; y < grid.rows; ++y) {
        EXPECT_EQ(region.contains({x, y}), expected.contains({x, y})) << x << "," << y;
      }
    }
  }
}

TEST(GoalRegion, BoundsThePlacesThatAreKept) {
  GoalRegion region(Goal(Point{5.5, 5.5}, 2), Cell{5, 5}, {0.5, 1, 10, 10});
  EXPECT_EQ(region.nearest_in_box({0, 9}), (Cell{3, 7}));
  EXPECT_TRUE(region.keep_if([](Cell place) { return place.x > 5; }));
  EXPECT_EQ(region.nearest_in_box({0, 9}), (Cell{6, 6}));
  EXPECT_EQ(region.nearest_in_box({9, 0}), (Cell{7, 4}));
  EXPECT_EQ(region.any().x, 6);
  EXPECT_FALSE(region.keep_if([](Cell) { return false; }));
  EXPECT_TRUE(region.empty());
}

TEST(GoalRegion, TakesATolerancePastTheMap) {
  EXPECT_EQ(
      places_of(GoalRegion(Goal(Point{1e12, 0}, kInfinity), std::nullopt, {0.5, 1, 3, 2})).size(),
      6U);
  EXPECT_TRUE(GoalRegion(Goal(Point{kInfinity, 0}, 5), std::nullopt, {0.5, 1, 3, 2}).empty());
  EXPECT_TRUE(GoalRegion(Goal(Point{kNaN, 0}, 5), std::nullopt, {0.5, 1, 3, 2}).empty());
}

TEST(GoalRegion, EntrancesAreWhereAPathFirstEntersIt) {
  const FreeSpace space = test::open_space(11, 11);
  const auto open = [&](Cell cell) { return space.contains(cell) && space.passable(cell); };
  const std::vector regions{GoalRegion(Goal(Point{5.5, 5.5}, 2), Cell{5, 5}, cells_of(space))};
  std::vector<Cell> entrances;
  append_entrances(regions, {0, 0}, open, entrances);
  EXPECT_EQ(entrances.size(), 12U) << "all but the inner cell";
  EXPECT_THAT(entrances, ::testing::Not(::testing::Contains(Cell{5, 5})));
  entrances.clear();
  append_entrances(regions, {5, 5}, open, entrances);
  EXPECT_THAT(entrances, ElementsAre(Cell{5, 5})) << "the start is in it";
}

/// h(u) <= cost(u, v) + h(v) for every step, and 0 at a goal.
TEST(GoalCells, EstimatesAreConsistent) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<GoalRegion> regions;
    for (int count = random.between(1, 3); count > 0; --count) {
      const Cell cell{random.between(0, 11), random.between(0, 11)};
      regions.emplace_back(Goal(centre_of(cell), random.chance(0.5) ? 0 : 3 * random.uniform()),
                           cell, PlaceGrid{0.5, 1, 12, 12});
    }
    GoalCells goals;
    goals.assign(regions);
    const auto h = [&](Cell from) {
      return goals.least(
          from, [from](Cell goal) { return std::hypot(from.x - goal.x, from.y - goal.y); });
    };
    for (const Cell cell : CellRange(12, 12)) {
      EXPECT_EQ(goals.contains(cell), any_contains(regions, cell));
      if (goals.contains(cell)) {
        EXPECT_EQ(h(cell), 0);
      }
      for (const Cell step : {Cell{1, 0}, Cell{0, 1}, Cell{1, 1}, Cell{-1, 1}}) {
        const Cell next{cell.x + step.x, cell.y + step.y};
        EXPECT_LE(std::abs(h(cell) - h(next)), std::hypot(step.x, step.y) + 1e-12);
      }
    }
  }
}

TEST(Goal, ReachesWhatIsWithinItsTolerances) {
  const Goal exact(Pose{2.5, 2.5, 1});
  EXPECT_FALSE(exact.reaches({2.5, 2.5})) << "the place of the point needs no tolerance";
  EXPECT_FALSE(exact.reaches_heading(1));
  const Goal goal(Pose{2.5, 2.5, kPi}, 0.3 / 0.1, 0.5);
  EXPECT_TRUE(goal.reaches({5.5, 2.5})) << "0.3 / 0.1 is less than 3";
  EXPECT_FALSE(goal.reaches({5.51, 2.5}));
  EXPECT_TRUE(goal.reaches_heading(-kPi + 0.5));
  EXPECT_FALSE(goal.reaches_heading(-kPi + 0.6));
  EXPECT_TRUE(Goal(Point{1, 1}, 2).reaches_heading(3)) << "any";
}

TEST(GoalTolerance, LetsTheGoalItselfBeBlockedOrOffTheMap) {
  const FreeSpace space = test::drawn_space(R"(
.....
...##
...##
)");
  for (const PlannerInfo& info : planners()) {
    SCOPED_TRACE(info.name);
    const auto planner = make_planner(info.name, space);
    ASSERT_TRUE(planner) << planner.error().message;
    for (const Point goal : {Point{4.5, 2.5}, Point{6.5, 1.5}}) {
      const Query exact{pose_at({0, 1}), {Goal(goal)}};
      EXPECT_FALSE((*planner)->plan(exact)) << goal.x;
      const Query near{pose_at({0, 1}), {Goal(goal, 4.2)}};
      const auto plan = (*planner)->plan(near);
      ASSERT_TRUE(plan) << goal.x << ": " << plan.error().message;
      EXPECT_LE(distance(plan->path.points().back(), goal), 4.2 + 1e-9);
    }
  }
}

}  // namespace
}  // namespace wend
