#include "wend/base/thread_workers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace wend {
namespace {

TEST(ThreadWorkers, DoEveryTaskOnce) {
  for (const unsigned count : {1U, 2U, 5U}) {
    ThreadWorkers workers(count);
    EXPECT_EQ(workers.count(), count);
    for (const std::size_t tasks : {0U, 1U, 3U, 1000U}) {
      std::vector<std::atomic<int>> done(tasks);
      workers.run(tasks, [&](std::size_t task, unsigned /*worker*/) { ++done[task]; });
      for (const auto& times : done) EXPECT_EQ(times, 1);
    }
  }
}

TEST(ThreadWorkers, NeverGiveTwoTasksToOneWorkerAtOnce) {
  constexpr unsigned kWorkers = 4;
  ThreadWorkers workers(kWorkers);
  std::vector<std::atomic<int>> busy(kWorkers);
  std::atomic<int> clashes{0};
  workers.run(2000, [&](std::size_t /*task*/, unsigned worker) {
    if (++busy[worker] != 1) ++clashes;
    --busy[worker];
  });
  EXPECT_EQ(clashes, 0);
}

TEST(ThreadWorkers, AreAsManyAsTheMachineRunsAtOnceUnlessTold) {
  EXPECT_GE(ThreadWorkers().count(), 1U);
}

}  // namespace
}  // namespace wend
