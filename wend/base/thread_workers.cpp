#include "wend/base/thread_workers.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace wend {
namespace {

/// What the workers of one run() share.
class Run {
 public:
  Run(std::size_t tasks, const Workers::Action& action) : tasks_(tasks), action_(action) {}

  void work(unsigned worker) noexcept {
    try {
      for (std::size_t task = next_++; task < tasks_; task = next_++) action_(task, worker);
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
      next_ = tasks_;
    }
  }

  /// Called when no worker is left.
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const std::size_t tasks_;
  const Workers::Action& action_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;  // guards thrown_
  std::exception_ptr thrown_;
};

/// Starts a worker. False if there is no thread, or no memory for one.
bool start(std::vector<std::jthread>& threads, Run& run, unsigned worker) {
  try {
    threads.emplace_back([&run, worker] { run.work(worker); });
    return true;
  } catch (const std::system_error&) {
    return false;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

}  // namespace

ThreadWorkers::ThreadWorkers(unsigned count)
    : count_(count > 0 ? count : std::max(1U, std::thread::hardware_concurrency())) {}

void ThreadWorkers::run(std::size_t tasks, const Action& action) {
  Run shared(tasks, action);
  {
    std::vector<std::jthread> threads;
    for (unsigned worker = 1; worker < count_ && worker < tasks; ++worker) {
      if (!start(threads, shared, worker)) break;
    }
    shared.work(0);
  }
  shared.rethrow();
}

}  // namespace wend
