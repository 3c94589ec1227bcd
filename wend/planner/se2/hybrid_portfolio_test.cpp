#include "wend/planner/se2/hybrid_portfolio.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace wend {
namespace {

/// Two halls and an alley between them, in which a long robot cannot turn from one door to the other; a disc within
/// it can.
FreeSpace two_halls() {
  Grid<CellState> states(60, 40, CellState::free);
  for (int y = 0; y < 40; ++y) {
    if (y < 15 || y > 17) states[{28, y}] = CellState::occupied;
    if (y < 23 || y > 25) states[{34, y}] = CellState::occupied;
  }
  return *make_free_space(*make_grid_map(states),
                          {.footprint = *parse_footprint("5,0.9;5,-0.9;-5,-0.9;-5,0.9")});
}

SearchOutcome outcome_of(const HybridBudget& budget, const Limits& limits, SearchMetrics& metrics) {
  const Steering steering(DriveKind::reeds_shepp, 4, DriveCosts{});
  HybridPortfolio searches(std::make_shared<const HybridGround>(two_halls()), steering,
                           HybridResolution{}, budget);
  const std::array<HybridGoal, 1> goals{HybridGoal{{50, 20, 0}, false, Goal{Point{50, 20}}, 0}};
  const SearchOutcome outcome = searches.run({8, 20, 1}, goals, limits, nullptr);
  metrics = searches.metrics();
  return outcome;
}

TEST(HybridPortfolio, EndsAQueryWithoutALimitAtItsOwn) {
  SearchMetrics metrics;
  EXPECT_EQ(outcome_of({.expansions = 3000}, {}, metrics), SearchOutcome::expansion_limit);
  EXPECT_EQ(metrics.expanded, 3000U);
}

TEST(HybridPortfolio, GoesByTheLimitOfTheQueryIfThereIsOne) {
  SearchMetrics metrics;
  Limits limits;
  limits.expansions = 3000;
  EXPECT_EQ(outcome_of({.expansions = 1000}, limits, metrics), SearchOutcome::expansion_limit);
  EXPECT_EQ(metrics.expanded, 3000U);
}

/// A clock that goes on by a second whenever somebody looks.
Clock ticking() {
  return [seconds = 0.0]() mutable { return ++seconds; };
}

TEST(HybridPortfolio, EndsAQueryWithoutALimitAtItsBudgetOfTime) {
  SearchMetrics metrics;
  EXPECT_EQ(outcome_of({.seconds = 20, .clock = ticking()}, {}, metrics),
            SearchOutcome::time_limit);
  EXPECT_GT(metrics.expanded, 0U);
  EXPECT_LE(metrics.expanded, 20U * 32);
}

TEST(HybridPortfolio, GoesByTheTimeLimitOfTheQueryIfThereIsOne) {
  SearchMetrics metrics;
  Limits limits;
  limits.clock = ticking();
  limits.seconds = 5;
  EXPECT_EQ(outcome_of({.seconds = 1, .clock = ticking()}, limits, metrics),
            SearchOutcome::time_limit);
  EXPECT_GT(metrics.expanded, 32U);
}

}  // namespace
}  // namespace wend
