#pragma once

// Workers: an executor of tasks that may run in any order. The core starts no threads; a program with
// threads passes an executor in (see thread_workers.hpp).
//
//   std::vector<int> squares(100);
//   wend::OneWorker().run(squares.size(), [&](std::size_t task, unsigned /*worker*/) {
//     squares[task] = static_cast<int>(task * task);
//   });

#include <cstddef>
#include <functional>

namespace wend {

class Workers {
 public:
  /// `worker` is less than count(). Tasks that run at the same time have different workers, so `worker`
  /// can be the index of scratch memory.
  using Action = std::function<void(std::size_t task, unsigned worker)>;

  virtual ~Workers() = default;

  /// The number of tasks that may run at the same time, at least 1.
  virtual unsigned count() const = 0;

  /// Runs tasks 0 to tasks - 1, in any order, and returns when all are done.
  virtual void run(std::size_t tasks, const Action& action) = 0;
};

/// Runs the tasks one after the other, in order.
class OneWorker final : public Workers {
 public:
  /// Always 1.
  unsigned count() const override { return 1; }
  /// Runs the tasks on the calling thread.
  void run(std::size_t tasks, const Action& action) override {
    for (std::size_t task = 0; task < tasks; ++task) action(task, 0);
  }
};

}  // namespace wend
