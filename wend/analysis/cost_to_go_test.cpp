#include "wend/analysis/cost_to_go.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/space/grid/cost_units.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;

constexpr double kUnreachable = std::numeric_limits<double>::infinity();

/// A field on a random map, its goals, and what the reference says of the same map.
struct Field {
  FreeSpace space;
  std::vector<Cell> goals;
  CostToGo field;
  test::Reference reference;

  /// From a cell to the nearest goal.
  double truth(Cell cell) const { return least[reference.number(cell)]; }
  std::vector<double> least;
};

template <class Check>
void on_random_fields(Check&& check) {
  for (std::uint64_t seed = 1; seed <= 400 && !::testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random);
    const FreeSpaceOptions robot = test::random_robot(random, map.frame().resolution);
    const FreeSpace space = *make_free_space(map, robot);
    const int corners = random.between(0, 2);
    const bool diagonals = random.chance(0.7);
    const GridMoves moves{diagonals ? Connectivity::eight : Connectivity::four,
                          static_cast<CornerRule>(corners)};
    const test::Reference reference(map, test::robot_in_cells(robot, map.frame()),
                                    {diagonals, corners});
    std::vector<Cell> goals;
    for (int i = random.between(1, 3); i > 0; --i) {
      const Cell goal = test::random_cell(random, map.width(), map.height());
      if (space.passable(goal)) goals.push_back(goal);
    }
    if (goals.empty()) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + ", corners cut " + std::to_string(corners) +
                 "\n" + test::drawing_of(map));
    auto field = CostToGo::make(space, goals, moves);
    ASSERT_TRUE(field);
    std::vector<double> least(map.size(), kUnreachable);
    for (const Cell goal : goals) {
      const std::vector<double> costs = reference.costs_from(goal);
      for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], costs[i]);
    }
    check(Field{space, goals, *std::move(field), reference, least});
  }
}

template <class Visit>
void for_all_cells(const FreeSpace& space, Visit&& visit) {
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) visit(Cell{x, y});
  }
}

/// Whole numbers choose among paths on cells with costs.
void expect_cost(double cost, double expected, Cell cell, const FreeSpace& space) {
  if (expected == kUnreachable) {
    ASSERT_EQ(cost, kUnreachable) << "at (" << cell.x << "," << cell.y << ")";
  } else {
    const double slack = space.uniform_terrain() ? 1e-9 : CostUnits::kMostExcess;
    ASSERT_NEAR(cost, expected, slack * (1 + expected)) << "at (" << cell.x << "," << cell.y << ")";
  }
}

TEST(CostToGo, IsTheCheapestCostFromEveryCell) {
  on_random_fields([](const Field& made) {
    for_all_cells(made.space, [&](Cell cell) {
      expect_cost(made.field.cost(cell), made.truth(cell), cell, made.space);
      EXPECT_EQ(made.field.costs()[cell], made.field.cost(cell));
    });
  });
}

TEST(CostToGo, LeadsToAGoalFromEveryCellForThatCost) {
  on_random_fields([](const Field& made) {
    for_all_cells(made.space, [&](Cell cell) {
      const auto plan = made.field.path_from(cell);
      if (!made.space.passable(cell)) {
        ASSERT_FALSE(plan);
        ASSERT_EQ(plan.error().status, Status::start_blocked);
        return;
      }
      if (made.truth(cell) == kUnreachable) {
        ASSERT_FALSE(plan);
        ASSERT_EQ(plan.error().status, Status::unreachable);
        return;
      }
      ASSERT_TRUE(plan);
      const auto cells = plan->path.cells();
      ASSERT_THAT(made.goals, ::testing::Contains(cells.back()));
      ASSERT_EQ(made.reference.fault(cells, cell, cells.back()), "");
      expect_cost(plan->cost, made.truth(cell), cell, made.space);
      // The field has the cost of its own path, not of the whole numbers.
      ASSERT_NEAR(plan->cost, made.field.cost(cell), 1e-9 * (1 + plan->cost));
      EXPECT_TRUE(plan->optimal());
    });
  });
}

/// Every step of the policy comes as much nearer as it costs.
TEST(CostToGo, HasAPolicyThatGoesDownhill) {
  on_random_fields([](const Field& made) {
    for_all_cells(made.space, [&](Cell cell) {
      const auto direction = made.field.policy(cell);
      const double cost = made.field.cost(cell);
      ASSERT_EQ(direction.has_value(), cost > 0 && cost < kUnreachable);
      if (!direction) return;
      const Cell next = step(cell, *direction);
      ASSERT_TRUE(made.reference.is_step(cell, next));
      ASSERT_NEAR(made.field.cost(next) + made.reference.step_cost(cell, next), cost,
                  1e-9 * (1 + cost));
    });
  });
}

TEST(CostToGo, ExpandsEveryCellThatCanReachAGoalOnce) {
  on_random_fields([](const Field& made) {
    std::uint64_t reachable = 0;
    for_all_cells(made.space,
                  [&](Cell cell) { reachable += made.truth(cell) < kUnreachable ? 1 : 0; });
    EXPECT_EQ(made.field.metrics().expanded, reachable);
  });
}

constexpr std::string_view kTwoRooms = "...#..\n...#..";

std::string failure_of(const std::vector<Cell>& goals, const Limits& limits = {}) {
  const auto field = CostToGo::make(test::drawn_space(kTwoRooms), goals, {}, limits);
  return std::string(to_string(field ? Status::found : field.error().status));
}

TEST(CostToGo, SaysWhyItCannotBeMade) {
  EXPECT_EQ(failure_of({}), "unsupported_query");
  EXPECT_EQ(failure_of({{6, 0}}), "goal_outside");
  EXPECT_EQ(failure_of({{0, -1}}), "goal_outside");
  EXPECT_EQ(failure_of({{3, 0}}), "goal_blocked");
  EXPECT_EQ(failure_of({{3, 0}, {6, 0}}), "goal_blocked") << "as the first";
  EXPECT_EQ(failure_of({{6, 0}, {3, 0}}), "goal_outside") << "as the first";
  EXPECT_EQ(failure_of({{0, 0}}), "found");
}

TEST(CostToGo, StopsAtItsLimitsAndKeepsTheMetrics) {
  Limits limits;
  limits.expansions = 4;
  EXPECT_EQ(failure_of({{0, 0}}, limits), "expansion_limit");
  const auto field =
      CostToGo::make(test::drawn_space(kTwoRooms), std::array{Cell{0, 0}}, {}, limits);
  EXPECT_EQ(field.error().metrics.expanded, 4U);
  limits.expansions = 6;
  EXPECT_EQ(failure_of({{0, 0}}, limits), "found") << "the room has six cells";

  const std::atomic<bool> cancel = true;
  limits.cancel = &cancel;
  EXPECT_EQ(failure_of({{0, 0}}, limits), "cancelled");

  Limits timed;
  double now = 0;
  timed.clock = [&] { return now++; };
  timed.seconds = 0.5;
  EXPECT_EQ(failure_of({{0, 0}}, timed), "time_limit");
}

TEST(CostToGo, SaysWhyThereIsNoPath) {
  const auto field = CostToGo::make(test::drawn_space(kTwoRooms), std::array{Cell{0, 0}});
  ASSERT_TRUE(field);
  EXPECT_EQ(field->path_from({6, 0}).error().status, Status::start_outside);
  EXPECT_EQ(field->path_from({3, 0}).error().status, Status::start_blocked);
  EXPECT_EQ(field->path_from({4, 0}).error().status, Status::unreachable);
  EXPECT_EQ(field->cost({4, 0}), kUnreachable);
  EXPECT_EQ(field->cost({3, 0}), kUnreachable);
}

TEST(CostToGo, AGoalIsThere) {
  const std::array goals{Cell{0, 0}, Cell{0, 0}, Cell{5, 1}};
  const std::array with_useless_ones{goals[0], Cell{3, 0}, goals[1], Cell{0, -1}, goals[2]};
  const auto field = CostToGo::make(test::drawn_space(kTwoRooms), with_useless_ones);
  ASSERT_TRUE(field);
  for (const Cell goal : goals) {
    EXPECT_EQ(field->cost(goal), 0);
    EXPECT_FALSE(field->policy(goal));
    EXPECT_THAT(field->path_from(goal)->path.cells(), ElementsAre(goal));
  }
  EXPECT_EQ(field->cost({4, 1}), 1) << "the nearest goal is the other room's";
}

}  // namespace
}  // namespace wend
