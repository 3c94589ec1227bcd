#include "wend/base/deadline.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

namespace wend {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Deadline, NeverPassesWithoutLimits) {
  const Deadline none;
  EXPECT_FALSE(none.bounded());
  EXPECT_FALSE(none.passed());
  EXPECT_EQ(none.seconds_left(), kInfinity);
  EXPECT_FALSE(Deadline(Limits{.expansions = 1, .clock = {}}).bounded());
}

TEST(Deadline, CountsFromItsBeginning) {
  double now = 100;
  const Deadline deadline(Limits{.expansions = 7, .seconds = 3, .clock = [&] { return now; }});
  EXPECT_TRUE(deadline.bounded());
  now = 102;
  EXPECT_FALSE(deadline.passed());
  EXPECT_EQ(deadline.seconds_left(), 1);
  EXPECT_EQ(deadline.left().seconds, 1);
  EXPECT_EQ(deadline.left().expansions, 7U);
  now = 104;
  EXPECT_TRUE(deadline.passed());
  EXPECT_EQ(deadline.status(), Status::time_limit);
  EXPECT_EQ(deadline.left().seconds, 0);
  EXPECT_EQ(deadline.text(), "stopped after 3 s");
}

TEST(Deadline, PassesWhenTheFlagIsSetAlsoByTheClock) {
  std::atomic<bool> cancel = false;
  double now = 0;
  const Deadline deadline(Limits{.clock =
                                     [&] {
                                       if (now > 5) cancel = true;
                                       return now;
                                     },
                                 .cancel = &cancel});
  EXPECT_FALSE(deadline.passed());
  now = 6;
  EXPECT_TRUE(deadline.passed());
  EXPECT_EQ(deadline.status(), Status::cancelled);
  EXPECT_EQ(deadline.text(), "cancelled");
  EXPECT_FALSE(deadline.without_cancel().passed());
}

/// A planner refuses it.
TEST(Deadline, KeepsALimitThatIsNaN) {
  const Deadline deadline(Limits{.seconds = std::nan(""), .clock = {}});
  EXPECT_TRUE(std::isnan(deadline.left().seconds));
}

TEST(DeadlineCheck, StaysPassed) {
  std::atomic<bool> cancel = true;
  const Deadline deadline(Limits{.clock = {}, .cancel = &cancel});
  DeadlineCheck check(&deadline);
  int calls = 0;
  while (!check()) ASSERT_LT(++calls, 10'000);
  cancel = false;
  EXPECT_TRUE(check());
  EXPECT_TRUE(check.now());
  DeadlineCheck never;
  EXPECT_FALSE(never.now());
}

}  // namespace
}  // namespace wend
