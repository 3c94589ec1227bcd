// Holds every planner of the registry that drives a car to what it guarantees, on thousands of random
// yards, against a brute force that shares no code with wend: a Dijkstra over corners and headings,
// and a simulator that integrates every move. A new planner is tested by being listed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "conformance/answer.hpp"
#include "tests/testing/car_simulator.hpp"
#include "tests/testing/car_trial.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kRelative = 1e-9;
// For each planner.
constexpr std::uint64_t kYards = test::share_of(600);
constexpr std::uint64_t kYardsOfALongRun = 10000;

/// By how much an answer misses what was asked, where the reference takes it.
SnappingError snapping_error_of(Point asked, std::optional<double> heading, const Pose& taken) {
  const double turn = heading ? std::remainder(*heading - taken.heading, 2 * std::numbers::pi) : 0;
  return {std::hypot(asked.x - taken.x, asked.y - taken.y), std::abs(turn)};
}

bool is_near(const SnappingError& a, const SnappingError& b) {
  return std::abs(a.distance - b.distance) < kRelative && std::abs(a.turn - b.turn) < kRelative;
}

/// Checks a drive by itself: legal, of the cost that it claims, from the start to a goal.
void expect_honest(const Plan& plan, const CarReference& reference, const Query& query) {
  EXPECT_EQ(fault_of(plan, reference), "");
  ASSERT_FALSE(plan.path.empty());
  const std::vector<Pose> poses = plan.path.poses();
  const auto first = reference.nearest(poses.front());
  const auto last = reference.nearest(poses.back());
  EXPECT_EQ(first, reference.nearest(query.start));
  EXPECT_TRUE(is_near(plan.start_snapping_error,
                      snapping_error_of(query.start.point(), query.start.heading, poses.front())));
  const bool ends_in_a_goal =
      std::any_of(query.goals.begin(), query.goals.end(), [&](const Goal& goal) {
        const std::vector<Stand> stands = stands_of(goal, reference);
        return std::find(stands.begin(), stands.end(), last) != stands.end() &&
               is_near(plan.goal_snapping_error,
                       snapping_error_of(goal.point, goal.heading, poses.back()));
      });
  EXPECT_TRUE(ends_in_a_goal) << "goal shift " << plan.goal_snapping_error.distance << ","
                              << plan.goal_snapping_error.turn;
  EXPECT_GE(plan.metrics.expanded, poses.size()) << "every pose of a drive was expanded";
}

void expect_as_guaranteed(const Plan& plan, const PlannerInfo& info, const CarTruth& truth) {
  EXPECT_GE(plan.cost, truth.fuel * (1 - kRelative)) << "cheaper than possible";
  EXPECT_GE(plan.bound, 1);
  EXPECT_LE(plan.cost, plan.bound * truth.fuel * (1 + kRelative)) << "bound " << plan.bound;
  if (info.guarantee == Guarantee::optimal) {
    EXPECT_TRUE(plan.optimal());
  }
  EXPECT_TRUE(info.guarantee < Guarantee::bounded || plan.bound < Plan::kNoBound);
}

void expect_true_answer(const PlannerInfo& info, const Answer& answer,
                        const CarReference& reference, const Query& query) {
  const CarTruth truth = truth_of(reference, query);
  if (answer.status == Status::found) {
    ASSERT_THAT(truth.failures, ::testing::IsEmpty()) << "found, though there is no drive";
    expect_honest(answer.plan, reference, query);
    expect_as_guaranteed(answer.plan, info, truth);
    return;
  }
  EXPECT_TRUE(answer.plan.path.empty());
  EXPECT_TRUE(answer.plan.moves.empty());
  EXPECT_EQ(answer.plan.cost, kInfinite);
  EXPECT_THAT(truth.failures, ::testing::Contains(answer.status)) << to_string(answer.status);
}

class CarConformance : public ::testing::TestWithParam<std::string> {
 protected:
  const PlannerInfo& info() const { return *planners().find(GetParam()); }

  std::unique_ptr<Planner> make(const Trial& trial) const {
    auto made = info().make(*make_free_space(trial.map, trial.robot), trial.options);
    if (made) return *std::move(made);
    EXPECT_FALSE(has_room(trial, rules_of(trial, info()))) << made.error().message;
    EXPECT_EQ(to_string(made.error().status), to_string(Status::unsupported_map));
    return nullptr;
  }

  void expect_guarantees_on_random_yards(std::uint64_t yards) const;
};

void CarConformance::expect_guarantees_on_random_yards(std::uint64_t yards) const {
  std::uint64_t found = 0;
  std::uint64_t turned_away = 0;
  for (std::uint64_t seed = 1; seed <= yards && !HasFailure(); ++seed) {
    const Trial trial = random_car_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = make(trial);
    if (planner == nullptr) continue;
    const CarReference reference = car_reference_for(trial, info());
    Random random(seed);
    for (int i = 0; i < 4 && !HasFailure(); ++i) {
      const Query query = random_drive(random, reference);
      SCOPED_TRACE(text_of(query));
      const Answer answer = answer_of(*planner, query);
      expect_true_answer(info(), answer, reference, query);
      if (!planner->anytime()) {  // which may expand a pose again
        EXPECT_GE(answer.plan.metrics.generated, answer.plan.metrics.expanded);
      }
      EXPECT_NE(planner->reason(query, answer.status), "");
      found += answer.status == Status::found ? 1 : 0;
      turned_away += answer.status == Status::unreachable ? 1 : 0;
    }
  }
  EXPECT_GT(found, yards) << "too few drives to say anything";
  EXPECT_GT(turned_away, yards / 20);
}

TEST_P(CarConformance, KeepsItsGuaranteesOnRandomYards) {
  expect_guarantees_on_random_yards(kYards);
}

TEST_P(CarConformance, KeepsItsGuaranteesOnManyRandomYardsInALongRun) {
  expect_guarantees_on_random_yards(kYardsOfALongRun);
}

/// All 512 yards of 3 x 3 cells, from everywhere on two sides to everywhere.
TEST_P(CarConformance, KeepsItsGuaranteesOnEveryYardOfNineCells) {
  for (unsigned bits = 0; bits < 512 && !HasFailure(); ++bits) {
    Grid<CellState> states(3, 3, CellState::free);
    for (int i = 0; i < 9; ++i) {
      if (((bits >> i) & 1U) != 0) states[{i % 3, i / 3}] = CellState::occupied;
    }
    Random random(bits);
    const Trial trial{*make_grid_map(states), {}, {}};
    SCOPED_TRACE(text_of(trial, bits));
    const auto planner = make(trial);
    const CarReference reference = car_reference_for(trial, info());
    for (int i = 0; i < 16; ++i) {
      const Stand start{{i % 4, 0}, random.between(0, 3)};
      const Stand goal{{i / 4, 3}, random.between(0, 3)};
      const Query query{reference.pose(start), {reference.pose(goal)}};
      SCOPED_TRACE(text_of(query));
      const Answer answer = answer_of(*planner, query);
      expect_true_answer(info(), answer, reference, query);
      EXPECT_GE(answer.plan.metrics.generated, answer.plan.metrics.expanded);
    }
  }
}

TEST_P(CarConformance, AStartThatIsTheGoalIsADriveOfOnePose) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Trial trial = random_car_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = make(trial);
    if (planner == nullptr) continue;
    const CarReference reference = car_reference_for(trial, info());
    Random random(seed);
    const Pose pose = reference.pose(random_stand(random, reference));
    Plan plan;
    const Status status = planner->plan({pose, {pose}}, plan);
    if (!reference.passable(reference.nearest(pose)->corner)) {
      EXPECT_EQ(to_string(status), to_string(Status::start_blocked));
      continue;
    }
    ASSERT_EQ(to_string(status), to_string(Status::found));
    EXPECT_EQ(fault_of(plan, reference), "");
    EXPECT_EQ(plan.path.size(), 1U);
    EXPECT_EQ(plan.cost, 0);
    EXPECT_EQ(plan.metrics, (SearchMetrics{1, 1, 1}));
  }
}

TEST_P(CarConformance, AReusedPlannerAnswersLikeAFreshOne) {
  for (std::uint64_t seed = 1; seed <= 60 && !HasFailure(); ++seed) {
    const Trial trial = random_car_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto reused = make(trial);
    if (reused == nullptr) continue;
    const CarReference reference = car_reference_for(trial, info());
    Random random(seed);
    for (int i = 0; i < 10 && !HasFailure(); ++i) {
      const Query query = random_drive(random, reference);
      SCOPED_TRACE(text_of(query));
      EXPECT_EQ(answer_of(*reused, query), answer_of(*make(trial), query));
    }
  }
}

TEST_P(CarConformance, AnUpdatedPlannerAnswersLikeAFreshOne) {
  std::unique_ptr<Planner> updated;
  OptionValues options;
  for (std::uint64_t seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    Trial trial = random_car_trial(seed, info());
    if (updated == nullptr) options = trial.options;
    trial.options = options;
    SCOPED_TRACE(text_of(trial, seed));
    const auto fresh = make(trial);
    if (updated != nullptr) updated->update(*make_free_space(trial.map, trial.robot));
    if (fresh == nullptr) {
      if (updated == nullptr) continue;
      const Pose anywhere{0, 0, 0};
      EXPECT_EQ(to_string(answer_of(*updated, {anywhere, {anywhere}}).status),
                to_string(Status::unsupported_map));
      continue;
    }
    if (updated == nullptr) updated = make(trial);
    const CarReference reference = car_reference_for(trial, info());
    Random random(seed);
    for (int i = 0; i < 3; ++i) {
      const Query query = random_drive(random, reference);
      EXPECT_EQ(answer_of(*updated, query), answer_of(*fresh, query));
    }
    if (seed % 25 == 0) updated.reset();  // other options from here on
  }
}

TEST_P(CarConformance, SteppingAndWatchingChangeNothing) {
  for (std::uint64_t seed = 1; seed <= 300 && !HasFailure(); ++seed) {
    const Trial trial = random_car_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner = make(trial);
    if (planner == nullptr) continue;
    Random random(seed);
    const Query query = random_drive(random, car_reference_for(trial, info()));
    SCOPED_TRACE(text_of(query));
    const Answer answer = answer_of(*planner, query);
    EXPECT_EQ(stepping_fault(*planner, info(), query, answer), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, CarConformance, ::testing::ValuesIn(planner_names("car")),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
