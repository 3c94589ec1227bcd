#include "wend/base/thread_workers.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace wend {

ThreadWorkers::ThreadWorkers(unsigned count)
    : count_(count > 0 ? count : std::max(1U, std::thread::hardware_concurrency())) {}

void ThreadWorkers::run(std::size_t tasks, const Action& action) {
  std::atomic<std::size_t> next{0};
  const auto work = [&](unsigned worker) {
    for (std::size_t task = next++; task < tasks; task = next++) action(task, worker);
  };
  std::vector<std::jthread> threads;
  for (unsigned worker = 1; worker < count_ && worker < tasks; ++worker) {
    threads.emplace_back(work, worker);
  }
  work(0);
}

}  // namespace wend
