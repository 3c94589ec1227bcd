#pragma once

// Workers: who does what can be done in any order. The core has no threads of its own; a program
// that has some passes them in (see thread_workers.hpp).
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
  /// `worker` is below count(); no two tasks have the same one at the same time, so that it can name
  /// memory of its own.
  using Action = std::function<void(std::size_t task, unsigned worker)>;

  virtual ~Workers() = default;

  virtual unsigned count() const = 0;

  /// Runs tasks 0 to tasks - 1, in any order, and returns when all are done.
  virtual void run(std::size_t tasks, const Action& action) = 0;
};

/// Runs them one after the other, in their order.
class OneWorker final : public Workers {
 public:
  unsigned count() const override { return 1; }
  void run(std::size_t tasks, const Action& action) override {
    for (std::size_t task = 0; task < tasks; ++task) action(task, 0);
  }
};

}  // namespace wend
