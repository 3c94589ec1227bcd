// Holds every planner of the registry to what it guarantees, on thousands of random maps, against a
// reference Dijkstra that shares no code with wend. A new planner is tested by being listed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/testing/answer.hpp"
#include "tests/testing/random_map.hpp"
#include "tests/testing/trial.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kOptimalRelative = 1e-9;
// For each planner and test that walks random maps.
constexpr std::uint64_t kMaps = 600;
constexpr std::uint64_t kMapsOfALongRun = 10000;

/// Checks a path by itself: valid step by step, with the cost that it claims.
void expect_honest(const Plan& plan, const PlannerInfo& info, const Reference& reference,
                   const TestQuery& test_query) {
  const auto cells = plan.path.cells();
  ASSERT_FALSE(cells.empty());
  EXPECT_THAT(test_query.goals, ::testing::Contains(cells.back()));
  const std::string fault = info.any_angle
                                ? reference.any_angle_fault(cells, test_query.start, cells.back())
                                : reference.fault(cells, test_query.start, cells.back());
  EXPECT_EQ(fault, "");
  EXPECT_NEAR(plan.cost, reference.cost_of(cells), kOptimalRelative * std::max(1.0, plan.cost));
  EXPECT_GE(plan.metrics.generated, plan.metrics.expanded);
  if (info.jumps) return;
  EXPECT_GE(plan.metrics.expanded, cells.size()) << "every cell of a path was expanded";
}

/// Checks a plan against what its planner guarantees.
void expect_as_guaranteed(const Plan& plan, const PlannerInfo& info, const Truth& truth) {
  // Lines may be shorter than steps; that they are free has been checked.
  if (!info.any_angle) {
    EXPECT_GE(plan.cost, truth.cost * (1 - kOptimalRelative)) << "cheaper than possible";
  }
  EXPECT_GE(plan.bound, 1);
  if (plan.bound < Plan::kNoBound) {
    EXPECT_LE(plan.cost, plan.bound * truth.cost * (1 + kOptimalRelative))
        << "bound " << plan.bound;
  }
  if (info.guarantee == Guarantee::fewest_steps) {
    EXPECT_EQ(static_cast<double>(plan.path.size() - 1), truth.steps);
  }
  if (info.guarantee == Guarantee::optimal) {
    EXPECT_TRUE(plan.optimal());
  }
}

void expect_true_answer(const PlannerInfo& info, Status status, const Plan& plan,
                        const Reference& reference, const Truth& truth,
                        const TestQuery& test_query) {
  if (status == Status::found) {
    EXPECT_THAT(truth.failures, ::testing::IsEmpty()) << "found, though there is no path";
    expect_honest(plan, info, reference, test_query);
    expect_as_guaranteed(plan, info, truth);
    return;
  }
  EXPECT_TRUE(plan.path.empty());
  EXPECT_EQ(plan.cost, kInfinite);
  if (info.guarantee == Guarantee::none && status == Status::step_limit) return;
  EXPECT_THAT(truth.failures, ::testing::Contains(status)) << to_string(status);
}

class Conformance : public ::testing::TestWithParam<std::string> {
 protected:
  const PlannerInfo& info() const { return *planners().find(GetParam()); }

  /// A planner for a trial, or none where it says that it does not plan on terrain.
  std::unique_ptr<Planner> make(const Trial& trial) const {
    const FreeSpace space = *make_free_space(trial.map, trial.robot);
    auto made = info().make(space, trial.options);
    if (made) return *std::move(made);
    const bool may_refuse = !space.uniform_terrain() && !info().plans_on_terrain &&
                            made.error().status == Status::unsupported_map;
    EXPECT_TRUE(may_refuse) << made.error().message;
    return nullptr;
  }

  void expect_guarantees_on_random_maps(std::uint64_t maps) const;
};

void Conformance::expect_guarantees_on_random_maps(std::uint64_t maps) const {
  std::uint64_t found = 0;
  for (std::uint64_t seed = 1; seed <= maps && !HasFailure(); ++seed) {
    const Trial trial = random_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = make(trial);
    if (planner == nullptr) continue;
    const Reference reference = reference_for(trial, info());
    Random random(seed);
    for (int i = 0; i < 4 && !HasFailure(); ++i) {
      const TestQuery test_query = random_test_query(random, trial.map);
      SCOPED_TRACE(text_of(test_query));
      Plan plan;
      const Status status = planner->plan(test_query.query(), plan);
      found += status == Status::found ? 1 : 0;
      expect_true_answer(info(), status, plan, reference,
                         truth_of(reference, trial.map, test_query), test_query);
    }
  }
  EXPECT_GT(found, maps / 2) << "too few paths to say anything";
}

TEST_P(Conformance, KeepsItsGuaranteesOnRandomMaps) { expect_guarantees_on_random_maps(kMaps); }

TEST_P(Conformance, KeepsItsGuaranteesOnManyRandomMapsInALongRun) {
  expect_guarantees_on_random_maps(kMapsOfALongRun);
}

/// All 512 maps of 3 x 3 cells, from the middle and from a corner to everywhere.
TEST_P(Conformance, KeepsItsGuaranteesOnEveryMapOfNineCells) {
  for (unsigned bits = 0; bits < 512 && !HasFailure(); ++bits) {
    Grid<CellState> states(3, 3, CellState::free);
    for (int i = 0; i < 9; ++i) {
      if (((bits >> i) & 1U) != 0) states[{i % 3, i / 3}] = CellState::occupied;
    }
    Random random(bits);
    const FreeSpaceOptions robot;
    const Trial trial{*make_grid_map(states), robot, random_options(random, info().options)};
    SCOPED_TRACE(text_of(trial, bits));
    const auto planner = make(trial);
    ASSERT_NE(planner, nullptr);
    const Reference reference = reference_for(trial, info());
    for (int i = 0; i < 18; ++i) {
      const TestQuery test_query{i < 9 ? Cell{1, 1} : Cell{0, 0}, {{i % 3, i / 3 % 3}}};
      SCOPED_TRACE(text_of(test_query));
      Plan plan;
      const Status status = planner->plan(test_query.query(), plan);
      expect_true_answer(info(), status, plan, reference,
                         truth_of(reference, trial.map, test_query), test_query);
    }
  }
}

TEST_P(Conformance, AReusedPlannerAnswersLikeAFreshOne) {
  for (std::uint64_t seed = 1; seed <= 6 && !HasFailure(); ++seed) {
    Random random(seed);
    const FreeSpaceOptions robot;
    const Trial trial{random_map(random, 20, 15), robot, random_options(random, info().options)};
    SCOPED_TRACE(text_of(trial, seed));
    const auto reused = make(trial);
    if (reused == nullptr) continue;
    for (int i = 0; i < 50 && !HasFailure(); ++i) {
      const TestQuery test_query = random_test_query(random, trial.map);
      SCOPED_TRACE(text_of(test_query));
      const Answer fresh_answer = answer_of(*make(trial), test_query.query());
      EXPECT_EQ(answer_of(*reused, test_query.query()), fresh_answer);
    }
  }
}

TEST_P(Conformance, AnUpdatedPlannerAnswersLikeAFreshOne) {
  std::unique_ptr<Planner> updated;
  OptionValues options;
  for (std::uint64_t seed = 1; seed <= 100 && !HasFailure(); ++seed) {
    Trial trial = random_trial(seed, info());
    if (updated == nullptr) options = trial.options;
    trial.options = options;
    SCOPED_TRACE(text_of(trial, seed));
    const auto fresh = make(trial);
    if (fresh == nullptr) continue;
    if (updated == nullptr) {
      updated = make(trial);
    } else {
      updated->update(fresh->free_space());
    }
    Random random(seed);
    for (int i = 0; i < 3; ++i) {
      const Query query = random_test_query(random, trial.map).query();
      EXPECT_EQ(answer_of(*updated, query), answer_of(*fresh, query));
    }
    if (seed % 25 == 0) updated.reset();  // other options from here on
  }
}

TEST_P(Conformance, SteppingAndWatchingChangeNothing) {
  for (std::uint64_t seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    const Trial trial = random_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = make(trial);
    if (planner == nullptr) continue;
    Random random(seed);
    const Query query = random_test_query(random, trial.map).query();
    const Answer answer = answer_of(*planner, query);

    expect_same_when_stepped_and_watched(*planner, info(), query, answer);
  }
}

TEST_P(Conformance, WhoRefusesTerrainRefusesItWhenUpdatedToo) {
  const Grid<CellState> cells(8, 8, CellState::free);
  const FreeSpace flat = *make_free_space(*make_grid_map(cells));
  const FreeSpace rough = *make_free_space(*make_grid_map(cells, {}, Grid<double>(8, 8, 2.0)));
  if (info().make(rough, {})) GTEST_SKIP() << GetParam() << " takes maps with terrain";
  const auto made = info().make(flat, {});
  ASSERT_TRUE(made);
  const Query query = Query::between({1, 1}, {6, 5});
  Plan plan;
  EXPECT_EQ((*made)->plan(query, plan), Status::found);
  (*made)->update(rough);
  EXPECT_EQ((*made)->plan(query, plan), Status::unsupported_map);
  (*made)->update(flat);
  EXPECT_EQ((*made)->plan(query, plan), Status::found);
}

/// The map with its rows in the opposite order.
GridMap mirrored(const GridMap& map) {
  const int last = map.height() - 1;
  Grid<CellState> states(map.width(), map.height());
  Grid<double> terrain(map.width(), map.height());
  for (int y = 0; y <= last; ++y) {
    for (int x = 0; x < map.width(); ++x) {
      states[{x, y}] = map.state({x, last - y});
      terrain[{x, y}] = map.terrain({x, last - y});
    }
  }
  return *make_grid_map(states, map.frame(), terrain);
}

TEST_P(Conformance, AMirroredMapCostsTheSame) {
  for (std::uint64_t seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    const Trial trial = random_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = make(trial);
    if (planner == nullptr) continue;
    const auto other = make({mirrored(trial.map), trial.robot, trial.options});
    const auto mirrored_cell = [&](Cell cell) {
      return Cell{cell.x, trial.map.height() - 1 - cell.y};
    };
    Random random(seed);
    const TestQuery test_query = random_test_query(random, trial.map);
    TestQuery mirrored_query{mirrored_cell(test_query.start), {}};
    for (const Cell goal : test_query.goals) mirrored_query.goals.push_back(mirrored_cell(goal));
    const Answer expected = answer_of(*planner, test_query.query());
    if (expected.status != Status::found || !expected.plan.optimal()) continue;
    const Answer answer = answer_of(*other, mirrored_query.query());
    EXPECT_EQ(to_string(answer.status), to_string(Status::found));
    EXPECT_NEAR(answer.plan.cost, expected.plan.cost, 1e-9 * expected.plan.cost);
  }
}

TEST_P(Conformance, TheSameGridGivesTheSameSearchWithYUpAndYDown) {
  for (std::uint64_t seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    const Trial trial = random_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = make(trial);
    if (planner == nullptr) continue;
    Frame frame = trial.map.frame();
    frame.y_up = !frame.y_up;
    const auto other = make({test::in_frame(trial.map, frame), trial.robot, trial.options});
    Random random(seed);
    const Query query = random_test_query(random, trial.map).query();
    EXPECT_EQ(answer_of(*other, query), answer_of(*planner, query));
  }
}

TEST_P(Conformance, AStartThatIsTheGoalIsAPathOfOneCell) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Trial trial = random_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = make(trial);
    if (planner == nullptr) continue;
    Random random(seed);
    const Cell cell = random_cell(random, trial.map.width(), trial.map.height());
    Plan plan;
    const Status status = planner->plan(Query::between(cell, cell), plan);
    if (!planner->free_space().passable(cell)) {
      EXPECT_EQ(to_string(status), to_string(Status::start_blocked));
      continue;
    }
    ASSERT_EQ(to_string(status), to_string(Status::found));
    EXPECT_THAT(plan.path.cells(), ::testing::ElementsAre(cell));
    EXPECT_EQ(plan.cost, 0);
    EXPECT_EQ(plan.metrics, (SearchMetrics{1, 1, 1}));
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, Conformance, ::testing::ValuesIn(planner_names(StateKind::cell)),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
