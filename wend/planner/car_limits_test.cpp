// When the car stops: limits hold with every heuristic, also while the estimates are made.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>

#include "wend/planner/planners.hpp"

namespace wend {
namespace {

/// A thick wall with a gate at its lower end, and with a crooked one that is near, but too narrow
/// for a car: it moves sideways by one cell.
FreeSpace walled_yard() {
  constexpr int kSide = 60;
  Grid<CellState> states(kSide, kSide, CellState::free);
  for (int y = 0; y < kSide - 3; ++y) {
    for (int x = 27; x <= 32; ++x) {
      const bool crooked = (x <= 29 && (y == 10 || y == 11)) || (x >= 29 && (y == 11 || y == 12));
      if (!crooked) states[{x, y}] = CellState::occupied;
    }
  }
  return *make_free_space(*make_grid_map(states));
}

/// With each heuristic: some search while they estimate, and find late that the near gate is
/// closed.
class CarLimits : public ::testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Planner> planner_ =
      make_planner("car", walled_yard(), {{"heuristic", GetParam()}}).value();
  Query query_{{24, 11, 0}, {Pose{35, 12, 0}}};

  std::string status() {
    Plan plan;
    return std::string(to_string(planner_->plan(query_, plan)));
  }
};

TEST_P(CarLimits, HoldForExpansions) {
  const auto unlimited = planner_->plan(query_);
  ASSERT_TRUE(unlimited);
  const std::uint64_t needed = unlimited->metrics.expanded;
  for (const std::uint64_t limit : {std::uint64_t{0}, std::uint64_t{1}, needed / 2, needed - 1}) {
    query_.limits.expansions = limit;
    const auto failed = planner_->plan(query_);
    ASSERT_FALSE(failed) << limit;
    EXPECT_EQ(to_string(failed.error().status), "expansion_limit");
    EXPECT_EQ(failed.error().metrics.expanded, limit);
  }
  query_.limits.expansions = needed;
  EXPECT_TRUE(planner_->plan(query_)) << "what it needs is enough";
}

/// A second goes by between two looks at the clock.
TEST_P(CarLimits, HoldForTime) {
  double now = 0;
  int looks = 0;
  query_.limits.clock = [&] {
    ++looks;
    return now++;
  };
  query_.limits.seconds = 1e9;
  EXPECT_EQ(status(), "found");
  const int needed = looks;
  EXPECT_GT(needed, 1);
  int failures = 0;
  for (int seconds = 0; seconds <= needed; ++seconds) {
    looks = 0;
    query_.limits.seconds = seconds + 0.5;
    const std::string outcome = status();
    EXPECT_THAT(outcome, ::testing::AnyOf("found", "time_limit"));
    failures += outcome == "time_limit" ? 1 : 0;
    if (outcome == "found") {
      EXPECT_EQ(looks, needed);
    }
  }
  EXPECT_GE(failures, 1);
  EXPECT_LE(failures, needed);
  query_.limits.seconds = needed;
  EXPECT_EQ(status(), "found");
}

TEST_P(CarLimits, HoldForCancelling) {
  std::atomic<bool> cancel = true;
  query_.limits.cancel = &cancel;
  EXPECT_EQ(status(), "cancelled");
  cancel = false;
  EXPECT_EQ(status(), "found");
}

/// From the clock, so in the midst of the search, or of its estimates.
TEST_P(CarLimits, HoldForCancellingInTheMidst) {
  std::atomic<bool> cancel = false;
  int looks = 0;
  int cancel_at = 0;
  query_.limits.cancel = &cancel;
  query_.limits.clock = [&] {
    if (++looks == cancel_at) cancel = true;
    return 0.0;
  };
  EXPECT_EQ(status(), "found");
  const int last = looks;
  for (cancel_at = 1; cancel_at < last; ++cancel_at) {
    looks = 0;
    cancel = false;
    EXPECT_EQ(status(), "cancelled") << "at look " << cancel_at << " of " << last;
  }
}

INSTANTIATE_TEST_SUITE_P(Heuristics, CarLimits,
                         ::testing::Values("zero", "diagonal", "headings", "obstacles"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend
