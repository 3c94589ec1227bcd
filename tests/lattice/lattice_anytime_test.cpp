// `car` and `lattice` with an initial weight: every path that they tell, against searches of the tests' own that
// share no code with wend, and what limits leave.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "tests/testing/anytime_work.hpp"
#include "tests/testing/car_simulator.hpp"
#include "tests/testing/car_trial.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/primitive_distances.hpp"
#include "tests/testing/share.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kRoundedTo = 1e-9;

struct ToldDrives {
  Status status = Status::found;
  Plan plan;
  std::vector<Plan> told;  // in order
};

ToldDrives drives_of(Planner& planner, Query query) {
  ToldDrives drives;
  query.on_solution = [&](const Plan& plan) { drives.told.push_back(plan); };
  drives.status = planner.plan(query, drives.plan);
  return drives;
}

/// Costs and bounds never rise, and the last drive is the answer.
void expect_in_order(const ToldDrives& drives) {
  for (std::size_t i = 1; i < drives.told.size(); ++i) {
    EXPECT_LE(drives.told[i].cost, drives.told[i - 1].cost * (1 + kRoundedTo));
    EXPECT_LE(drives.told[i].bound, drives.told[i - 1].bound * (1 + kRoundedTo));
    EXPECT_GE(drives.told[i].metrics.expanded, drives.told[i - 1].metrics.expanded);
  }
  if (drives.status != Status::found) {
    EXPECT_THAT(drives.told, IsEmpty());
    EXPECT_THAT(drives.plan.path.driven_poses(), IsEmpty());
    return;
  }
  ASSERT_FALSE(drives.told.empty());
  EXPECT_EQ(drives.told.back().path, drives.plan.path);
  EXPECT_EQ(drives.told.back().bound, drives.plan.bound);
}

void expect_true_bound(const Plan& plan, double least) {
  EXPECT_GE(plan.bound, 1);
  EXPECT_GE(plan.cost, least * (1 - kRoundedTo));
  EXPECT_LE(plan.cost, plan.bound * least * (1 + kRoundedTo)) << "bound " << plan.bound;
}

/// At a limit on expansions: what was told until then, and an answer whose bound is true.
ToldDrives expect_true_at_limit(Planner& planner, Query query, const ToldDrives& all,
                                std::uint64_t limit) {
  query.limits.expansions = limit;
  ToldDrives drives = drives_of(planner, query);
  expect_in_order(drives);
  EXPECT_LE(drives.plan.metrics.expanded, limit);
  for (std::size_t i = 0; i < all.told.size() && all.told[i].metrics.expanded <= limit; ++i) {
    EXPECT_LT(i, drives.told.size());
    if (i < drives.told.size()) {
      EXPECT_EQ(drives.told[i].path, all.told[i].path);
    }
  }
  EXPECT_TRUE(drives.status == Status::found || drives.status == Status::expansion_limit)
      << to_string(drives.status);
  return drives;
}

TEST(AnytimeCar, TellsDrivesWithTrueBoundsOnRandomYards) {
  const PlannerInfo& info = *planners().find("car");
  int found = 0;
  int bettered = 0;
  for (std::uint64_t seed = 1; seed <= share_of(600U) && !::testing::Test::HasFailure(); ++seed) {
    Trial trial = random_car_trial(seed, info);
    Random random(seed);
    trial.options.emplace_back("initial_weight", format_number(1.5 + 8 * random.uniform()));
    trial.options.emplace_back("weight_step", format_number(0.1 + random.uniform()));
    const double last = random.chance(0.7) ? 1 : 1.25;
    trial.options.emplace_back("weight", format_number(last));
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = info.make(*make_free_space(trial.map, trial.robot), trial.options);
    if (!planner) continue;
    EXPECT_TRUE((*planner)->anytime());
    const CarReference reference = car_reference_for(trial, info);
    for (int i = 0; i < 4; ++i) {
      const Query query = random_drive(random, reference);
      const ToldDrives drives = drives_of(**planner, query);
      expect_in_order(drives);
      const CarTruth truth = truth_of(reference, query);
      EXPECT_EQ(drives.status == Status::found, truth.failures.empty());
      if (drives.status != Status::found || !truth.failures.empty()) continue;
      ++found;
      bettered += drives.told.back().cost < drives.told.front().cost - kRoundedTo ? 1 : 0;
      for (const Plan& plan : drives.told) {
        EXPECT_EQ(fault_of(plan, reference), "");
        expect_true_bound(plan, truth.fuel);
      }
      EXPECT_LE(drives.plan.bound, last * (1 + kRoundedTo));
      const std::uint64_t limit = random.below(drives.plan.metrics.expanded + 1);
      const ToldDrives limited = expect_true_at_limit(**planner, query, drives, limit);
      if (limited.status == Status::found) expect_true_bound(limited.plan, truth.fuel);
    }
  }
  EXPECT_GT(found, share_of(600));
  EXPECT_GT(bettered, share_of(20)) << "the first drives were the best";
}

struct MotionTrial {
  FreeSpace space;
  double radius;  // turning circle
  Query query;
};

/// For a point.
MotionTrial random_motion_trial(std::uint64_t seed) {
  Random random(seed);
  const int width = random.between(6, 16);
  const int height = random.between(6, 16);
  Grid<CellState> cells(width, height, CellState::free);
  const double share = 0.3 * random.uniform();
  for (const Cell cell : every_cell(cells)) {
    if (random.chance(share)) cells[cell] = CellState::occupied;
  }
  const auto pose = [&] {
    const double x = random.between(0, width - 1) + 0.5;
    const double y = random.between(0, height - 1) + 0.5;
    return Pose{x, y, random.between(0, 3) * kPi / 2};
  };
  const double radius = random.chance(0.5) ? 0 : 1 + random.uniform();
  const Pose start = pose();
  const Pose goal = pose();
  return {*make_free_space(*make_grid_map(cells)), radius, Query{start, {goal}}};
}

/// The least cost from the start to the goal; kNoMotion if there is no way. A point that touches a corner may
/// pass for the planner or not, so a disc that is a little larger has the upper bound.
double least_motion_cost(const MotionTrial& trial, const FreeSpaceOptions& robot) {
  const MotionPrimitives primitives = *MotionPrimitives::turning_circle(trial.radius);
  const auto grid_pose = [&](const Pose& pose) {
    return GridPose{cell_at(pose.point()), primitives.nearest_heading(pose.heading)};
  };
  const LatticeCosts lattice_costs{};
  const FreeSpace space = *make_free_space(trial.space.map(), robot);
  const PrimitiveDistances distances(space, primitives, lattice_costs.reverse_factor,
                                     lattice_costs.turn_cost);
  const auto costs = distances.from(grid_pose(trial.query.start));
  const Goal& goal = trial.query.goals.front();
  const auto found = costs.find(grid_pose({goal.point.x, goal.point.y, *goal.heading}));
  return found == costs.end() ? kNoMotion : found->second;
}

TEST(AnytimeLattice, TellsDrivesWithTrueBoundsOnRandomMaps) {
  int found = 0;
  int bettered = 0;
  for (std::uint64_t seed = 1; seed <= share_of(400U) && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MotionTrial trial = random_motion_trial(seed);
    const double least = least_motion_cost(trial, {});
    const double most = least_motion_cost(trial, {.footprint = Footprint::disc(1e-6)});
    const auto within = [&](const Plan& plan) {
      EXPECT_GE(plan.bound, 1);
      EXPECT_GE(plan.cost, least * (1 - kRoundedTo));
      EXPECT_LE(plan.cost, plan.bound * most * (1 + kRoundedTo)) << "bound " << plan.bound;
    };
    for (const auto heuristic : {LatticeHeuristic::distance, LatticeHeuristic::obstacles}) {
      const auto planner = make_planner(trial.space, LatticeOptions{.turning_radius = trial.radius,
                                                                    .heuristic = heuristic,
                                                                    .initial_weight = 8,
                                                                    .weight_step = 0.3});
      ASSERT_TRUE(planner) << planner.error().message;
      const ToldDrives drives = drives_of(**planner, trial.query);
      expect_in_order(drives);
      if (drives.status != Status::found) continue;
      ++found;
      bettered += drives.told.back().cost < drives.told.front().cost - kRoundedTo ? 1 : 0;
      for (const Plan& plan : drives.told) within(plan);
      EXPECT_TRUE(drives.plan.optimal());
      Random random(seed);
      const std::uint64_t limit = random.below(drives.plan.metrics.expanded + 1);
      const ToldDrives limited = expect_true_at_limit(**planner, trial.query, drives, limit);
      if (limited.status == Status::found) within(limited.plan);
    }
  }
  EXPECT_GT(found, share_of(200));
  EXPECT_GT(bettered, share_of(20)) << "the first drives were the best";
}

/// The start is in a pocket that opens away from the goal.
const FreeSpace& pocket() {
  static const FreeSpace space = drawn_space(R"(
............................
............................
..###################.......
....................#.......
....................#.......
....................#.......
..###################.......
............................
............................
)");
  return space;
}

class AnytimeDrives : public ::testing::TestWithParam<std::string> {
 protected:
  static std::unique_ptr<Planner> make(OptionValues options = {{"initial_weight", "20"}}) {
    // The estimate must not know the pocket.
    options.emplace_back("heuristic", GetParam() == "car" ? "headings" : "distance");
    return std::move(make_planner(GetParam(), pocket(), options).value());
  }

  /// On corners and on centres of cells.
  static Query query() {
    const double half = GetParam() == "car" ? 0 : 0.5;
    return {Pose{8 + half, 4 + half, 0}, {Pose{26 + half, 4 + half, 0}}};
  }
};

TEST_P(AnytimeDrives, AreBetteredUntilTheBest) {
  const auto planner = make();
  const auto optimum = make({});
  EXPECT_TRUE(planner->anytime());
  EXPECT_FALSE(optimum->anytime());
  const ToldDrives drives = drives_of(*planner, query());
  ASSERT_EQ(drives.status, Status::found);
  EXPECT_GT(drives.told.size(), 1U);
  EXPECT_GT(drives.told.front().bound, 1);
  EXPECT_LT(drives.told.front().metrics.expanded, drives.plan.metrics.expanded);
  EXPECT_TRUE(drives.plan.optimal());
  EXPECT_NEAR(drives.plan.cost, optimum->plan(query())->cost, kRoundedTo);
}

TEST_P(AnytimeDrives, AreTheOneOfTheWeightWithoutAHigherInitialWeight) {
  const auto planner = make({{"weight", "3"}, {"initial_weight", "3"}});
  const auto expected = make({{"weight", "3"}});
  EXPECT_FALSE(planner->anytime());
  const ToldDrives drives = drives_of(*planner, query());
  EXPECT_THAT(drives.told, SizeIs(1));
  EXPECT_EQ(drives.plan.path, expected->plan(query())->path);
  EXPECT_EQ(drives.plan.bound, 3);
}

TEST_P(AnytimeDrives, AreTheSameWhenStepped) {
  const auto planner = make();
  const ToldDrives drives = drives_of(*planner, query());
  Query stepped = query();
  std::vector<double> bounds;
  stepped.on_solution = [&](const Plan& plan) { bounds.push_back(plan.bound); };
  Plan plan;
  auto outcome = planner->begin(stepped, plan);
  while (!outcome) outcome = planner->step(plan);
  EXPECT_EQ(*outcome, Status::found);
  ASSERT_THAT(bounds, SizeIs(drives.told.size()));
  for (std::size_t i = 0; i < bounds.size(); ++i) EXPECT_EQ(bounds[i], drives.told[i].bound);
  EXPECT_EQ(plan.path, drives.plan.path);
}

TEST_P(AnytimeDrives, EndWithTheBestAtATimeLimit) {
  const auto planner = make();
  double now = 0;
  Query timed = query();
  timed.limits.clock = [&] { return now; };
  timed.limits.seconds = 1;
  std::size_t told = 0;
  timed.on_solution = [&](const Plan&) {
    ++told;
    now = 2;  // the clock strikes with the first drive
  };
  Plan plan;
  ASSERT_EQ(planner->plan(timed, plan), Status::found);
  EXPECT_GE(told, 1U);
  EXPECT_LE(plan.cost, plan.bound * make({})->plan(query())->cost * (1 + kRoundedTo));
}

TEST_P(AnytimeDrives, AreNoneWhenCancelled) {
  const auto planner = make();
  std::atomic<bool> cancel = true;
  Query cancelled = query();
  cancelled.limits.cancel = &cancel;
  const ToldDrives drives = drives_of(*planner, cancelled);
  EXPECT_EQ(drives.status, Status::cancelled);
  EXPECT_THAT(drives.told, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Planners, AnytimeDrives, ::testing::Values("car", "lattice"),
                         [](const auto& test) { return test.param; });

/// The way around the obstacles is searched as far as it is asked for. The clock strikes in that search.
TEST(AnytimeLattice, KeepsItsDriveWhenTheEstimateIsCutOff) {
  const auto map = make_map("rooms", 101, 101, 1);
  ASSERT_TRUE(map);
  const FreeSpace space = *make_free_space(*map);
  const auto planner = *make_planner(space, LatticeOptions{.initial_weight = 10});
  const auto optimum = *make_planner(space, LatticeOptions{});
  Random random(3);
  int answers = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose start = pose_at(random_cell(random, 101, 101));
    Query query{start, {pose_at(random_cell(random, 101, 101))}};
    const auto best = optimum->plan(query);
    if (!best) continue;
    double reads = 0;
    query.limits.clock = [&] { return ++reads; };  // a limit in reads of the clock
    for (const double seconds : {2.5, 10.5, 40.5, 160.5}) {
      reads = 0;
      query.limits.seconds = seconds;
      const ToldDrives drives = drives_of(*planner, query);
      expect_in_order(drives);
      if (drives.status == Status::time_limit) continue;
      ASSERT_EQ(drives.status, Status::found);
      ++answers;
      expect_true_bound(drives.plan, best->cost);
    }
  }
  EXPECT_GT(answers, 20);
}

/// The expansions until the proof, over those of A*.
double work_beside_astar(const FreeSpace& space, const OptionValues& options,
                         const std::string& name) {
  OptionValues anytime = options;
  anytime.emplace_back("initial_weight", "3");
  const auto planner = *make_planner(name, space, anytime);
  const auto astar = *make_planner(name, space, options);
  Random random(5);
  return anytime_work(*planner, *astar, 12, [&] {
    const Pose start = pose_at(random_cell(random, space.width(), space.height()));
    return Query{start, {pose_at(random_cell(random, space.width(), space.height()))}};
  });
}

TEST(AnytimeDrive, TakesAtMostTwoAndAHalfTimesTheWorkOfAStar) {
  double logarithms = 0;
  int maps = 0;
  for (const char* name : {"random", "rooms", "office", "parking"}) {
    const auto map = make_map(name, 81, 81, 1);
    ASSERT_TRUE(map) << name;
    const FreeSpace space = *make_free_space(*map);
    const double car = work_beside_astar(space, {}, "car");
    const double lattice = work_beside_astar(space, {{"turning_radius", "2"}}, "lattice");
    std::cout << name << ": car " << car << ", lattice " << lattice
              << " times the expansions of A*\n";
    logarithms += std::log(car) + std::log(lattice);
    maps += 2;
  }
  const double mean = std::exp(logarithms / maps);
  std::cout << "geometric mean " << mean << '\n';
  EXPECT_LE(mean, 2.5);
}

}  // namespace
}  // namespace wend::test
