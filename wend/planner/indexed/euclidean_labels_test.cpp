// euclidean_labels beside any_angle, which the brute force of any_angle_test.cpp checks.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "conformance/random_map.hpp"
#include "tests/fuzz/forged_index.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/planner/planners.hpp"

namespace wend {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double kRelative = 1e-9;

Grid<CellState> scattered(Random& random, int longest) {
  const int width = random.between(1, longest);
  const int height = random.between(1, longest);
  Grid<CellState> states(width, height, CellState::free);
  const double blocked = 0.45 * random.uniform();
  for (const Cell cell : every_cell(states)) {
    if (random.chance(blocked)) states[cell] = CellState::occupied;
  }
  return states;
}

FreeSpaceOptions random_robot(Random& random) {
  const int kind = random.between(0, 2);
  const double ahead = 0.3 + random.uniform();
  const double side = 0.2 + 0.6 * random.uniform();
  if (kind == 0) return {};
  if (kind == 1) return {.footprint = Footprint::disc(ahead)};
  return {.footprint = *Footprint::polygon(
              *Polygon::make({{ahead, side}, {-side, side}, {-side, -side}, {ahead, -side}}))};
}

std::unique_ptr<Planner> labels_on(const FreeSpace& space) {
  auto planner = planners().find("euclidean_labels")->make(space, {});
  if (!planner) ADD_FAILURE() << planner.error().message;
  return planner ? *std::move(planner) : nullptr;
}

/// Whether there was a path.
bool expect_answer_of_any_angle(Planner& labels, const FreeSpace& space, const Query& query) {
  const auto reference = make_planner(space, ShortestAnyAngleOptions{});
  Plan plan;
  Plan expected;
  const Status status = labels.plan(query, plan);
  EXPECT_EQ(status, (*reference)->plan(query, expected));
  if (status != Status::found) return false;
  const auto collision = first_collision(plan.path, space, Adjacency::edges);
  EXPECT_FALSE(collision) << describe(collision->kind);
  EXPECT_EQ(plan.cost, plan.path.length());
  EXPECT_EQ(plan.path.points().front(), expected.path.points().front());
  EXPECT_EQ(plan.path.points().back(), expected.path.points().back());
  EXPECT_EQ(plan.bound, expected.bound);
  if (space.is_point()) {
    EXPECT_NEAR(plan.cost, expected.cost, kRelative * (1 + expected.cost));
  } else {
    EXPECT_LE(plan.cost, 1.5 * expected.cost + 1) << "pulled taut on another way round";
  }
  return true;
}

TEST(EuclideanLabels, AnswersAsAnyAngleDoes) {
  int found = 0;
  const auto maps = test::share_of(1500U);
  for (std::uint64_t seed = 1; seed <= maps && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GridMap map = *make_grid_map(scattered(random, 30));
    const FreeSpaceOptions robot = random_robot(random);
    const FreeSpace space = *make_free_space(map, robot);
    const auto labels = labels_on(space);
    ASSERT_NE(labels, nullptr);
    for (int i = 0; i < 4; ++i) {
      const Cell start = test::random_cell(random, map.width(), map.height());
      const Cell goal = test::random_cell(random, map.width(), map.height());
      if (expect_answer_of_any_angle(*labels, space, Query::between(start, goal))) ++found;
    }
  }
  EXPECT_GT(found, static_cast<int>(maps));
}

TEST(EuclideanLabels, TakesTheNearestOfSeveralGoals) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 300 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GridMap map = *make_grid_map(scattered(random, 30));
    const FreeSpace space = *make_free_space(map);
    const auto labels = labels_on(space);
    ASSERT_NE(labels, nullptr);
    const Cell start = test::random_cell(random, map.width(), map.height());
    const Cell goal = test::random_cell(random, map.width(), map.height());
    const Cell other = test::random_cell(random, map.width(), map.height());
    Query query = Query::between(start, goal);
    query.goals.push_back(Query::between(start, other).goals.front());
    Plan plan;
    Plan expected;
    const auto reference = make_planner(space, ShortestAnyAngleOptions{});
    ASSERT_EQ(labels->plan(query, plan), (*reference)->plan(query, expected));
    if (plan.path.empty()) continue;
    ++found;
    EXPECT_NEAR(plan.cost, expected.cost, kRelative * (1 + expected.cost));
  }
  EXPECT_GT(found, 100);
}

/// More posts than the index takes corners.
GridMap posts() {
  Grid<CellState> states(420, 420, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (cell.x % 3 == 1 && cell.y % 3 == 1) states[cell] = CellState::occupied;
  }
  return *make_grid_map(states);
}

TEST(EuclideanLabels, RefusesMapsOfTooManyCornersAndNamesAnotherPlanner) {
  const auto planner = planners().find("euclidean_labels")->make(*make_free_space(posts()), {});
  ASSERT_FALSE(planner);
  EXPECT_EQ(planner.error().status, Status::unsupported_map);
  EXPECT_THAT(planner.error().message, AllOf(HasSubstr("78400 corners"), HasSubstr("at most 65536"),
                                             HasSubstr("any_angle")));
}

TEST(EuclideanLabels, IsOfUseAgainOnceTheMapAllowsIt) {
  Random random(5);
  const FreeSpace small = *make_free_space(*make_grid_map(scattered(random, 30)));
  const FreeSpace large = *make_free_space(posts());
  const auto labels = labels_on(small);
  ASSERT_NE(labels, nullptr);
  EXPECT_FALSE(labels->update(large));
  Plan plan;
  const Query query = Query::between({0, 0}, {3, 2});
  EXPECT_EQ(labels->plan(query, plan), Status::unsupported_map);
  EXPECT_THAT(labels->plan(query).error().message, HasSubstr("any_angle"));
  ASSERT_TRUE(labels->update(small));
  expect_answer_of_any_angle(*labels, small, query);
}

TEST(EuclideanLabels, OfAForgedIndexLeadADiscAlongFreePathsOnly) {
  const FreeSpace space = test::space_for_forgery({.footprint = Footprint::disc(0.49)});
  const IndexSupport& support = *planners().find("euclidean_labels")->index_support;
  const IndexBytes index = support.build(space, {}).value();
  int opened = 0;
  int found = 0;
  const auto forgeries = test::share_of(600U);
  for (std::uint64_t seed = 1; seed <= forgeries && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::string changes;
    for (int i = 0; i < 6; ++i) changes.push_back(static_cast<char>(random.below(256)));
    const auto bytes = test::forged(index.bytes(), changes);
    const auto planner = support.make_planner(space, {}, IndexBytes::copy_of(bytes));
    if (!planner) continue;
    ++opened;
    for (int i = 0; i < 20; ++i) {
      const Cell start = test::random_cell(random, space.width(), space.height());
      const Cell goal = test::random_cell(random, space.width(), space.height());
      Plan plan;
      if ((*planner)->plan(Query::between(start, goal), plan) != Status::found) continue;
      ++found;
      EXPECT_FALSE(first_collision(plan.path, space, Adjacency::edges));
    }
  }
  EXPECT_GT(opened, 0);
  EXPECT_LT(opened, static_cast<int>(forgeries)) << "nothing is checked";
  EXPECT_GT(found, opened);
}

TEST(EuclideanLabels, RefusesTerrain) {
  Grid<double> terrain(2, 1, 1);
  terrain[{1, 0}] = 3;
  const GridMap uneven = *make_grid_map(Grid<CellState>(2, 1, CellState::free), {}, terrain);
  const auto planner = planners().find("euclidean_labels")->make(*make_free_space(uneven), {});
  ASSERT_FALSE(planner);
  EXPECT_EQ(planner.error().status, Status::unsupported_map);
}

}  // namespace
}  // namespace wend
