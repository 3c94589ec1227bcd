// Maps with directions, end to end: 2,000 random ones for each planner on cells that claims to know them, fields towards
// goals, smoothing, and what failures say.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "conformance/random_directions.hpp"
#include "conformance/suite.hpp"
#include "conformance/trial.hpp"
#include "tests/testing/share.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/refinement.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/failure_text.hpp"

namespace wend::test {
namespace {

std::vector<std::string> directed_planners_on_cells() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    if (info.capabilities.directions && !info.capabilities.headings) names.push_back(info.name);
  }
  return names;
}

class DirectedPlanners : public ::testing::TestWithParam<std::string> {};

TEST_P(DirectedPlanners, AgreeWithTheReferenceOnTwoThousandMaps) {
  constexpr std::uint64_t kMaps = 2000;
  constexpr std::uint64_t kSeed = 10'000;  // other maps than those of the conformance suite
  const CheckReport report = run_check(*find_check("directed"), *planners().find(GetParam()),
                                       {.maps = share_of(kMaps), .seed = kSeed});
  EXPECT_EQ(report.violations, 0U);
  EXPECT_GT(report.found, report.maps / 2);
  if (!report.smallest) return;
  ADD_FAILURE() << "expected: " << report.smallest->expected << "\ncame: " << report.smallest->came
                << "\nquery: " << report.smallest->query << '\n'
                << report.smallest->trial;
}

INSTANTIATE_TEST_SUITE_P(Registry, DirectedPlanners,
                         ::testing::ValuesIn(directed_planners_on_cells()),
                         [](const auto& test) { return test.param; });

TEST(Directions, AFieldHasTheCostsTowardsItsGoal) {
  const PlannerInfo& info = *planners().find("dijkstra");
  for (std::uint64_t seed = 0; seed < share_of(std::uint64_t{300}); ++seed) {
    Random random(seed);
    const GridMap map = with_random_directions(random, random_map(random));
    const Trial trial{map, random_robot(random, map.frame().resolution), {}};
    SCOPED_TRACE(text_of(trial, seed));
    const Reference reference = reference_for(trial, info);
    const FreeSpace space = *make_free_space(trial.map, trial.robot);
    const Cell goal = random_cell(random, map.width(), map.height());
    const auto field = CostToGo::make(space, std::array{goal});
    ASSERT_EQ(field.has_value(), reference.passable(goal));
    if (!field) continue;
    for (int i = 0; i < 4; ++i) {
      const Cell start = random_cell(random, map.width(), map.height());
      const double expected = reference.costs_from(start)[reference.number(goal)];
      if (std::isinf(expected)) {
        EXPECT_TRUE(std::isinf(field->cost(start)));
        continue;
      }
      EXPECT_NEAR(field->cost(start), expected, 2e-6 * (1 + expected));
      const auto path = field->path_from(start);
      ASSERT_TRUE(path);
      EXPECT_NEAR(path->cost, field->cost(start), 1e-9 * (1 + expected));
    }
  }
}

TEST(Directions, RefinedPathsLeadAgainstNoArrow) {
  int changed = 0;
  for (std::uint64_t seed = 0; seed < share_of(std::uint64_t{600}); ++seed) {
    Random random(seed);
    const GridMap map = with_random_directions(random, random_map(random));
    const Trial trial{map, random_robot(random, map.frame().resolution), {}};
    SCOPED_TRACE(text_of(trial, seed));
    const FreeSpace space = *make_free_space(trial.map, trial.robot);
    const auto plan = (*make_planner("astar", space))->plan(random_test_query(random, map).query());
    if (!plan) continue;
    ASSERT_FALSE(first_collision(plan->path, space));
    for (const bool smooth : {false, true}) {
      Refinement refinement;
      refinement.simplify = Simplification{};
      if (smooth) refinement.smoother = SmootherChoice{};
      const auto refined = wend::refined(plan->path, space, refinement);
      if (!refined) continue;
      const auto collision = first_collision(refined->path, space);
      EXPECT_FALSE(collision) << (collision ? describe(collision->kind) : "");
      changed += refined->path.points().size() != plan->path.points().size() ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 20);
}

/// A corridor of five cells whose middle one leads to the right.
FreeSpace one_way_corridor() {
  Grid<double> headings(5, 1, std::numeric_limits<double>::quiet_NaN());
  headings[{2, 0}] = 0;
  const GridMap map = *make_grid_map(Grid<CellState>(5, 1, CellState::free));
  return *make_free_space(*with_arrows(map, headings));
}

TEST(Directions, AFailureNamesTheArrow) {
  const FreeSpace space = one_way_corridor();
  for (const std::string& name : directed_planners_on_cells()) {
    SCOPED_TRACE(name);
    const auto planner = *make_planner(name, space);
    EXPECT_TRUE(planner->plan(Query::between({0, 0}, {4, 0})));
    const auto plan = planner->plan(Query::between({4, 0}, {0, 0}));
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().status, Status::unreachable);
    EXPECT_EQ(words_of(plan.error(), space),
              "there is no path from start (4,0) to goal (0,0) along the arrows: it is reachable "
              "against the arrow at (2,0)");
  }
  const NoPath why = explain_no_path(space, {4, 0}, {0, 0});
  EXPECT_EQ(why.arrow, (Cell{2, 0}));
  EXPECT_FALSE(why.path_exists());
  EXPECT_TRUE(explain_no_path(space, {0, 0}, {4, 0}).path_exists());
}

TEST(Directions, OtherPlannersSayWhy) {
  const FreeSpace space = one_way_corridor();
  for (const PlannerInfo& info : planners()) {
    const auto made = make_planner(info.name, space);
    if (info.capabilities.directions) continue;
    ASSERT_FALSE(made) << info.name;
    EXPECT_EQ(made.error().status, Status::unsupported_map);
    EXPECT_NE(made.error().message.find("does not plan on a map with directions"),
              std::string::npos)
        << made.error().message;
  }
}

TEST(Directions, ACheckFindsWhereAPathTurnsAgainstAnArrow) {
  const FreeSpace space = one_way_corridor();
  Path back;
  for (int x = 4; x >= 0; --x) back.append({x, 0});
  const auto collision = first_collision(back, space);
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->kind, CollisionKind::against);
  EXPECT_NEAR(collision->point.x, 2.875, 1e-3);
  EXPECT_EQ(collision->obstacle, (Cell{2, 0}));
}

}  // namespace
}  // namespace wend::test
