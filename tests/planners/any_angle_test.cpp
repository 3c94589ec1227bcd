// Planners that turn at any angle, against A* with its path pulled taut, on random maps.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "conformance/trial.hpp"
#include "tests/testing/share.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

using ::testing::Contains, ::testing::ElementsAre;

class AnyAngle : public ::testing::TestWithParam<std::string> {};

/// What the queries of many maps come to.
struct Lengths {
  int queries = 0;
  int longer = 0;  // than the taut path of A*
  double any_angle = 0;
  double taut = 0;
};

void compare(const Trial& trial, const std::string& name, std::uint64_t seed, Lengths& lengths) {
  const FreeSpace space = *make_free_space(trial.map, trial.robot);
  if (!space.uniform_terrain()) return;
  const auto planner = make_planner(name, space, trial.options);
  ASSERT_TRUE(planner);
  const auto astar = make_planner("astar", space, trial.options);
  ASSERT_TRUE(astar) << astar.error().message;
  const Adjacency adjacency = parse_options<GridMoves>(trial.options)->adjacency();
  Random random(seed);
  for (int i = 0; i < 4; ++i) {
    const Query query = random_test_query(random, trial.map).query();
    if (query.goals.size() > 1) continue;
    Plan plan;
    Plan reference;
    ASSERT_EQ((*planner)->plan(query, plan), (*astar)->plan(query, reference));
    if (plan.path.empty()) continue;
    const auto collision = first_collision(plan.path, space, adjacency);
    ASSERT_FALSE(collision) << describe(collision->kind);
    const double taut = string_pulled(reference.path, space, adjacency)->length();
    ++lengths.queries;
    lengths.longer += plan.cost > taut * (1 + 1e-9) ? 1 : 0;
    lengths.any_angle += plan.cost;
    lengths.taut += taut;
  }
}

TEST_P(AnyAngle, IsShorterOnAverageThanTautPathsOfAStarAndSeldomLonger) {
  Lengths lengths;
  const PlannerInfo& info = *planners().find(GetParam());
  for (std::uint64_t seed = 1; seed <= 3000 && !HasFailure(); ++seed) {
    Trial trial = random_trial(seed, info);
    std::erase_if(trial.options, [](const auto& option) { return option.first == "weight"; });
    SCOPED_TRACE(text_of(trial, seed));
    compare(trial, GetParam(), seed, lengths);
  }
  std::cout << GetParam() << ": longer in " << lengths.longer << " of " << lengths.queries
            << " queries, on average " << lengths.any_angle / lengths.taut << " times as long\n";
  EXPECT_GT(lengths.queries, 100);
  EXPECT_LE(lengths.any_angle, lengths.taut);
  EXPECT_LT(lengths.longer * 100, lengths.queries);
}

/// 7 x 5 cells with a wall from the top, four cells long.
FreeSpace walled() {
  Grid<CellState> cells(7, 5, CellState::free);
  for (int y = 0; y < 4; ++y) cells[{3, y}] = CellState::occupied;
  return *make_free_space(*make_grid_map(cells));
}

TEST_P(AnyAngle, GoesStraightWhereNothingIsInTheWay) {
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(30, 20, CellState::free)));
  const auto plan = (*make_planner(GetParam(), space))->plan(Query::between({2, 3}, {26, 10}));
  ASSERT_TRUE(plan);
  EXPECT_THAT(plan->path.cells(), ElementsAre(Cell{2, 3}, Cell{26, 10}));
  EXPECT_EQ(plan->cost, 25);
}

TEST_P(AnyAngle, TurnsAtTheEndOfAWall) {
  const auto plan = (*make_planner(GetParam(), walled()))->plan(Query::between({2, 0}, {4, 0}));
  ASSERT_TRUE(plan);
  EXPECT_THAT(plan->path.cells(),
              ElementsAre(Cell{2, 0}, Cell{2, 3}, Cell{3, 4}, Cell{4, 3}, Cell{4, 0}));
}

TEST_P(AnyAngle, PassesBetweenTwoCornersOnlyWhereItMay) {
  Grid<CellState> cells(2, 2, CellState::free);
  cells[{1, 0}] = cells[{0, 1}] = CellState::occupied;
  const FreeSpace space = *make_free_space(*make_grid_map(cells));
  for (const std::string rule : {"none", "one", "both"}) {
    const auto planner = make_planner(GetParam(), space, {{"corner_rule", rule}});
    Plan plan;
    const Status status = (*planner)->plan(Query::between({0, 0}, {1, 1}), plan);
    EXPECT_EQ(status, rule == "both" ? Status::found : Status::unreachable) << rule;
  }
}

TEST_P(AnyAngle, GoesRoundDearGroundAndStraightOverCheapGround) {
  Grid<double> terrain(9, 9, 2);
  for (int y = 0; y < 8; ++y) {
    for (int x = 3; x <= 5; ++x) terrain[{x, y}] = 100;
  }
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(9, 9, CellState::free), {}, terrain));
  const auto plan = (*make_planner(GetParam(), space))->plan(Query::between({0, 8}, {8, 8}));
  ASSERT_TRUE(plan);
  EXPECT_THAT(plan->path.cells(), ElementsAre(Cell{0, 8}, Cell{8, 8}));
  EXPECT_DOUBLE_EQ(plan->cost, 16);
  const auto round = (*make_planner(GetParam(), space))->plan(Query::between({0, 0}, {8, 0}));
  ASSERT_TRUE(round);
  EXPECT_THAT(round->path.cells(), Contains(testing::Field(&Cell::y, 8))) << "below the dear block";
  EXPECT_LT(round->cost, 60);
}

/// What the queries of many maps with costs come to.
struct Costs {
  int queries = 0;
  double any_angle = 0;
  double steps = 0;
};

void compare_costs(std::uint64_t seed, const std::string& name, Costs& costs) {
  const PlannerInfo& info = *planners().find(name);
  Trial trial = random_trial(seed, info);
  std::erase_if(trial.options, [](const auto& option) { return option.first == "weight"; });
  const FreeSpace space = *make_free_space(trial.map, trial.robot);
  if (space.uniform_terrain()) return;
  const auto planner = make_planner(name, space, trial.options);
  const auto astar = make_planner("astar", space, trial.options);
  ASSERT_TRUE(planner && astar);
  Random random(seed);
  for (int i = 0; i < 4; ++i) {
    const Query query = random_test_query(random, trial.map).query();
    Plan plan;
    Plan reference;
    ASSERT_EQ((*planner)->plan(query, plan), (*astar)->plan(query, reference));
    if (plan.path.empty()) continue;
    ++costs.queries;
    costs.any_angle += plan.cost;
    costs.steps += reference.cost;
  }
}

TEST_P(AnyAngle, CostsLessOnAverageThanTheCheapestStepsOnMapsWithCosts) {
  Costs costs;
  for (std::uint64_t seed = 1; seed <= share_of(3000U) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    compare_costs(seed, GetParam(), costs);
  }
  std::cout << GetParam() << ": on costs, on average " << costs.any_angle / costs.steps
            << " times the cost of the cheapest steps, in " << costs.queries << " queries\n";
  EXPECT_GT(costs.queries, 100);
  EXPECT_LT(costs.any_angle, costs.steps);
}

/// Keeps the cells that were expanded, with their parents.
struct Expansions : SearchObserver {
  void on_generate(const SearchEvent& /*event*/) override {}
  void on_relax(const SearchEvent& /*event*/) override {}
  void on_expand(const SearchEvent& event) override {
    if (event.parent) links.emplace_back(*event.parent, event.cell);
  }

  std::vector<std::pair<Cell, Cell>> links;
};

TEST_P(AnyAngle, ExpandsNoCellThatItsParentDoesNotSee) {
  const PlannerInfo& info = *planners().find(GetParam());
  std::size_t links = 0;
  for (std::uint64_t seed = 1; seed <= share_of(1000U) && !HasFailure(); ++seed) {
    const Trial trial = random_trial(seed, info);
    const auto planner =
        make_planner(GetParam(), *make_free_space(trial.map, trial.robot), trial.options);
    ASSERT_TRUE(planner);
    SCOPED_TRACE(text_of(trial, seed));
    const Reference reference = reference_for(trial, info);
    Random random(seed);
    Query query = random_test_query(random, trial.map).query();
    Expansions expansions;
    query.observer = &expansions;
    Plan plan;
    (*planner)->plan(query, plan);
    for (const auto& [parent, cell] : expansions.links) {
      EXPECT_EQ(reference.any_angle_fault(std::array{parent, cell}, parent, cell), "");
    }
    links += expansions.links.size();
  }
  EXPECT_GT(links, share_of(200U));
}

INSTANTIATE_TEST_SUITE_P(Registry, AnyAngle, ::testing::Values("theta_star", "lazy_theta_star"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
