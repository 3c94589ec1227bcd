#pragma once

// Interrupts: lets Ctrl-C stop what runs without the interpreter lock. At most every 20 ms it takes the lock and
// asks Python whether a signal has arrived; if so, it sets the cancel flag. (Python handles signals on its main
// thread only; on others nothing arrives.)

#include <nanobind/nanobind.h>

#include <atomic>
#include <functional>

#include "wend/base/limits.hpp"

namespace wend::python {

/// What make() returns, made without the interpreter lock.
template <class Make>
auto unlocked(Make&& make) {
  const nanobind::gil_scoped_release released;
  return make();
}

class Interrupts {
 public:
  static constexpr double kSeconds = 0.02;  // between two looks

  /// The flag that stops the work; it is set when a signal has arrived.
  const std::atomic<bool>& cancelled() const { return cancelled_; }

  /// Makes a search on the calling thread look, by its clock. This object outlives the search.
  void watch(Limits& limits);

  /// Runs work, without the lock and on a thread of its own, while the calling thread looks. Work of more than one
  /// thread stops when cancelled() is set. The caller does not hold the lock. What `work` throws, this throws. Where the
  /// system has no more threads, the calling thread works, and does not look.
  void run(const std::function<void()>& work);

  /// Throws the exception of the signal, if one has arrived. The caller holds the lock.
  void throw_if_interrupted() const;

 private:
  void look();

  std::atomic<bool> cancelled_ = false;
  double looked_ = steady_seconds();
};

}  // namespace wend::python
