#include "wend/base/thread_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace wend {
namespace {

/// A clock that only runs advance, and runs with given durations.
struct Work {
  double now = 0;
  std::uint64_t runs = 0;
  std::vector<double> seconds;  // of each run in order; the last one repeats

  Clock clock() {
    return [this] { return now; };
  }
  void operator()() {
    const std::size_t last = seconds.size() - 1;
    now += seconds[std::min<std::size_t>(runs++, last)];
  }
};

double least_of(Work& work, const RepetitionRule& rule = {}) {
  return least_seconds(work.clock(), [&work] { work(); }, rule);
}

TEST(ThreadTime, DoesNotGoBack) {
  double before = thread_cpu_seconds();
  for (int i = 0; i < 1000; ++i) {
    const double now = thread_cpu_seconds();
    EXPECT_GE(now, before);
    before = now;
  }
  EXPECT_GE(process_cpu_seconds(), before) << "this thread's is part of it";
  EXPECT_EQ(thread_time_name(), "CPU time") << "what Linux has";
}

TEST(SecondsOf, IsOneRun) {
  Work work{.seconds = {2, 1}};
  EXPECT_EQ(seconds_of(work.clock(), [&work] { work(); }), 2);
  EXPECT_EQ(work.runs, 1U);
}

TEST(Timed, AddsWhatARunTakesAndHandsOnItsResult) {
  Work work{.seconds = {2, 1}};
  double seconds = 0.5;
  const auto run = [&work] {
    work();
    return work.runs;
  };
  EXPECT_EQ(timed(work.clock(), seconds, run), 1U);
  EXPECT_EQ(timed(work.clock(), seconds, run), 2U);
  EXPECT_EQ(seconds, 3.5);
}

TEST(LeastSeconds, RunsOnceWhatFillsTheTimeAlone) {
  Work work{.seconds = {5e-3, 1e-3}};
  EXPECT_EQ(least_of(work), 5e-3);
  EXPECT_EQ(work.runs, 1U);
}

TEST(LeastSeconds, RunsOnceWhereThereIsNoTimeToFill) {
  Work work{.seconds = {1e-6}};
  EXPECT_EQ(least_of(work, {.fill_seconds = 0}), 1e-6);
  EXPECT_EQ(work.runs, 1U);
}

TEST(LeastSeconds, IsTheLeastOfTheRunsThatFillTheTime) {
  Work work{.seconds = {2e-3, 1e-3, 24e-3, 0.5e-3}};
  EXPECT_NEAR(least_of(work), 1e-3, 1e-12) << "not the run after the time was filled";
  EXPECT_EQ(work.runs, 3U);
}

TEST(LeastSeconds, TimesShortRunsTogether) {
  Work work{.seconds = {10e-6}};
  std::uint64_t looks = 0;
  const Clock clock = [&] {
    ++looks;
    return work.now;
  };
  EXPECT_NEAR(least_seconds(clock, [&work] { work(); }), 10e-6, 1e-12);
  EXPECT_GE(work.now, 5e-3);
  EXPECT_LT(work.now, 5e-3 + 80e-6 + 1e-9) << "eight at a time, and no more than needed";
  EXPECT_LT(looks, 2 * work.runs / 4);
}

TEST(LeastSeconds, LeavesOutRunsThatTheClockIsTooSlowFor) {
  Work work{.seconds = {1e-6, 30e-6}};
  EXPECT_NEAR(least_of(work), 30e-6, 1e-12) << "the first one was shorter than can be timed";
}

TEST(LeastSeconds, EndsWhereTheClockStandsStill) {
  Work work{.seconds = {0}};
  EXPECT_EQ(least_of(work, {.most_runs = 100}), 0);
  EXPECT_GE(work.runs, 100U);
  EXPECT_LT(work.runs, 200U);
}

}  // namespace
}  // namespace wend
