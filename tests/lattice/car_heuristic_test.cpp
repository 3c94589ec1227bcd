// The estimates of every planner that drives a car, as a query uses them: consistent on every edge
// under every option, and some of them exact on an empty yard.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/testing/car_trial.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kHeuristicRelative = 1e-9;
constexpr int kHeuristicYards = test::share_of(500);

/// The estimate of every stand, of a query begun last.
std::vector<double> estimates(const Planner& planner, const CarReference& reference) {
  std::vector<double> h(reference.count());
  for (std::size_t i = 0; i < h.size(); ++i) {
    h[i] = planner.heuristic(reference.pose(reference.stand(i)));
  }
  return h;
}

std::string place_of(const Stand& stand) {
  return "(" + std::to_string(stand.corner.x) + "," + std::to_string(stand.corner.y) + "," +
         std::to_string(stand.quarter) + ")";
}

/// The stands at which a search begun there can end.
std::vector<Stand> reachable_goals(const Query& query, const CarReference& reference) {
  const std::vector<double> fuel = reference.fuel_from(reference.nearest(query.start).value());
  std::vector<Stand> goals;
  for (const Goal& goal : query.goals) {
    for (const Stand& stand : stands_of(goal, reference)) {
      if (fuel[reference.number(stand)] < kInfinite) goals.push_back(stand);
    }
  }
  return goals;
}

void expect_consistent(const std::vector<double>& h, const CarReference& reference) {
  for (std::size_t from = 0; from < h.size(); ++from) {
    EXPECT_GE(h[from], 0);
    for (const CarReference::Edge& edge : reference.edges(from)) {
      ASSERT_LE(h[from], edge.fuel + h[edge.to] + kHeuristicRelative * (1 + h[from]))
          << kManeuvers[edge.maneuver].name << " from " << place_of(reference.stand(from));
    }
  }
}

void expect_admissible(const std::vector<double>& h, const std::vector<Stand>& goals,
                       const CarReference& reference) {
  const std::vector<double> fuel = reference.fuel_to(goals);
  for (std::size_t i = 0; i < h.size(); ++i) {
    ASSERT_LE(h[i], fuel[i] * (1 + kHeuristicRelative)) << place_of(reference.stand(i));
  }
  for (const Stand& goal : goals) EXPECT_EQ(h[reference.number(goal)], 0);
}

class CarHeuristics : public ::testing::TestWithParam<std::string> {
 protected:
  const PlannerInfo& info() const { return *planners().find(GetParam()); }

  std::unique_ptr<Planner> make(const GridMap& map, const OptionValues& options) const {
    return std::move(make_planner(GetParam(), *make_free_space(map), options).value());
  }
};

TEST_P(CarHeuristics, AreConsistentOnEveryEdgeOfRandomYards) {
  int informed = 0;
  for (std::uint64_t seed = 1; seed <= kHeuristicYards && !HasFailure(); ++seed) {
    const Trial trial = random_car_trial(seed, info());
    SCOPED_TRACE(text_of(trial, seed));
    if (!has_room(trial, rules_of(trial, info()))) continue;
    const auto planner =
        info().make(*make_free_space(trial.map, trial.robot), trial.options).value();
    const CarReference reference = car_reference_for(trial, info());
    Random random(seed);
    const Query query = random_drive(random, reference);
    SCOPED_TRACE(text_of(query));
    Plan plan;
    if (planner->begin(query, plan)) continue;  // an outcome, without a search
    const std::vector<double> h = estimates(*planner, reference);
    expect_consistent(h, reference);
    expect_admissible(h, reachable_goals(query, reference), reference);
    informed += h[reference.number(reference.nearest(query.start).value())] > 0 ? 1 : 0;
  }
  EXPECT_GT(informed, kHeuristicYards / 6) << "too few estimates to say anything";
}

constexpr int kFar = 9;                    // units around a goal
constexpr int kSide = 2 * kFar + 2 * 4;    // cells: a detour of 4 units stays on the yard
const Cell kMiddle{kSide / 2, kSide / 2};  // corner

/// Calls check(estimate, fuel) for every pose around a goal on an empty yard and every such goal.
template <class Check>
void on_empty_yards(const std::string& heuristic, const std::string& name, Check&& check) {
  for (const bool y_up : {false, true}) {
    Frame frame;
    frame.y_up = y_up;
    const GridMap map = *make_grid_map(Grid<CellState>(kSide, kSide, CellState::free), frame);
    const CarReference reference(map, {}, {});
    const auto planner =
        make_planner(name, *make_free_space(map), {{"heuristic", heuristic}}).value();
    for (int quarter = 0; quarter <= 4; ++quarter) {
      Goal goal(reference.pose({kMiddle, quarter}));
      if (quarter == 4) goal.heading.reset();
      SCOPED_TRACE((y_up ? "y up, quarter " : "y down, quarter ") + std::to_string(quarter));
      Plan plan;
      ASSERT_FALSE(planner->begin({{0, 0, 0}, {goal}}, plan));
      const std::vector<double> h = estimates(*planner, reference);
      const std::vector<double> fuel = reference.fuel_to(stands_of(goal, reference));
      for (std::size_t i = 0; i < h.size(); ++i) {
        const Stand stand = reference.stand(i);
        if (std::abs(stand.corner.x - kMiddle.x) > kFar) continue;
        if (std::abs(stand.corner.y - kMiddle.y) > kFar) continue;
        SCOPED_TRACE(place_of(stand));
        check(h[i], fuel[i]);
      }
    }
  }
}

TEST_P(CarHeuristics, ThatKnowHeadingsAreExactOnAnEmptyYard) {
  for (const std::string heuristic : {"headings", "obstacles"}) {
    on_empty_yards(heuristic, GetParam(), [](double h, double fuel) {
      EXPECT_NEAR(h, fuel, kHeuristicRelative * std::max(1.0, fuel));
    });
  }
}

/// Where the heading does not fit or must not, a car pays more than the diagonal estimate says; it
/// pays no more than a few turns more.
TEST_P(CarHeuristics, ThatDoNotAreExactForSomePosesOnly) {
  int exact = 0;
  int below = 0;
  on_empty_yards("diagonal", GetParam(), [&](double h, double fuel) {
    (h > fuel - kHeuristicRelative * std::max(1.0, fuel) ? exact : below) += 1;
    EXPECT_LE(fuel - h, 2 * std::numbers::pi);
  });
  EXPECT_GT(exact, test::share_of(1000));
  EXPECT_GT(below, test::share_of(1000));
  on_empty_yards("zero", GetParam(), [](double h, double) { EXPECT_EQ(h, 0); });
}

INSTANTIATE_TEST_SUITE_P(Registry, CarHeuristics, ::testing::ValuesIn(planner_names("car")),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
