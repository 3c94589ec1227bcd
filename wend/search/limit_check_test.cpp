#include "wend/search/limit_check.hpp"

#include <gtest/gtest.h>

#include <atomic>

namespace wend {
namespace {

constexpr std::uint64_t kBetween = Limits::kExpansionsBetweenClockReads;

/// How many states are expanded before the check ends the search, and how it ends.
std::pair<std::uint64_t, SearchOutcome> expansions_until_end(const Limits& limits) {
  LimitCheck check;
  check.begin(limits);
  for (std::uint64_t expanded = 0; expanded < 100 * kBetween; ++expanded) {
    if (!check.due(expanded)) continue;
    const SearchOutcome outcome = check.look(expanded);
    if (outcome != SearchOutcome::running) return {expanded, outcome};
  }
  return {100 * kBetween, SearchOutcome::running};
}

TEST(LimitCheck, ExpansionsAreCountedExactly) {
  for (const std::uint64_t most : {std::uint64_t{0}, std::uint64_t{1}, kBetween - 1, kBetween,
                                   kBetween + 1, 7 * kBetween + 3}) {
    Limits limits;
    limits.expansions = most;
    EXPECT_EQ(expansions_until_end(limits), std::pair(most, SearchOutcome::expansion_limit));
  }
}

TEST(LimitCheck, TheClockIsReadNowAndThen) {
  double now = 0;
  int reads = 0;
  Limits limits;
  limits.seconds = 2.5;
  limits.clock = [&] {
    ++reads;
    return now++;
  };
  // It begins at time 0 and reads the clock at 1, 2 and 3.
  EXPECT_EQ(expansions_until_end(limits), std::pair(2 * kBetween, SearchOutcome::time_limit));
  EXPECT_EQ(reads, 4);
}

TEST(LimitCheck, CancellingIsSeenAtOnceAtTheStart) {
  const std::atomic<bool> cancel = true;
  Limits limits;
  limits.cancel = &cancel;
  EXPECT_EQ(expansions_until_end(limits), std::pair(std::uint64_t{0}, SearchOutcome::cancelled));
}

TEST(LimitCheck, WithoutLimitsASearchGoesOn) {
  const Limits limits;
  EXPECT_EQ(expansions_until_end(limits).second, SearchOutcome::running);
}

}  // namespace
}  // namespace wend
