#include "wend/base/thread_workers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <cstddef>
#include <new>
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

TEST(ThreadWorkers, ThrowTheFirstExceptionOfATaskWhenAllHaveEnded) {
  for (const unsigned count : {1U, 4U}) {
    ThreadWorkers workers(count);
    std::atomic<int> running{0};
    std::atomic<int> begun{0};
    const auto run = [&] {
      workers.run(100'000, [&](std::size_t task, unsigned /*worker*/) {
        ++running;
        ++begun;
        --running;
        if (task == 7) throw std::bad_alloc();
      });
    };
    EXPECT_THROW(run(), std::bad_alloc);
    EXPECT_EQ(running, 0);
    EXPECT_GE(begun, 8);
    workers.run(10, [&](std::size_t /*task*/, unsigned /*worker*/) { ++begun; });  // still usable
  }
}

#ifdef __GLIBC__
TEST(ThreadWorkers, AreFewerWhereTheSystemHasNoMore) {
  pthread_attr_t usual;
  pthread_attr_t huge;  // no address space holds such a stack
  ASSERT_EQ(::pthread_getattr_default_np(&usual), 0);
  ASSERT_EQ(::pthread_getattr_default_np(&huge), 0);
  ASSERT_EQ(::pthread_attr_setstacksize(&huge, std::size_t{1} << 47U), 0);
  ASSERT_EQ(::pthread_setattr_default_np(&huge), 0);
  std::atomic<int> done{0};
  ThreadWorkers(4).run(100, [&](std::size_t /*task*/, unsigned worker) { done += worker == 0; });
  EXPECT_EQ(::pthread_setattr_default_np(&usual), 0);
  EXPECT_EQ(done, 100);
}
#endif

}  // namespace
}  // namespace wend
