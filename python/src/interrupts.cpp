#include "python/src/interrupts.hpp"

#include <nanobind/nanobind.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace nb = nanobind;

namespace wend::python {

void Interrupts::look() {
  if (cancelled_) return;
  const nb::gil_scoped_acquire locked;
  // The exception stays set on this thread: throw_if_interrupted() takes it.
  if (PyErr_CheckSignals() != 0) cancelled_ = true;
}

void Interrupts::watch(Limits& limits) {
  limits.cancel = &cancelled_;
  limits.clock = [this] {
    const double now = steady_seconds();
    if (now - looked_ >= kSeconds) {
      looked_ = now;
      look();
    }
    return now;
  };
}

void Interrupts::run(const std::function<void()>& work) {
  std::mutex mutex;
  std::condition_variable ended;
  bool done = false;
  std::exception_ptr thrown;
  const auto work_and_tell = [&] {
    try {
      work();
    } catch (...) {
      thrown = std::current_exception();
    }
    const std::scoped_lock lock(mutex);
    done = true;
    ended.notify_one();
  };
  std::thread worker;
  try {
    worker = std::thread(work_and_tell);
  } catch (const std::system_error&) {
    return work();
  }
  std::unique_lock lock(mutex);
  while (!ended.wait_for(lock, std::chrono::duration<double>(kSeconds), [&] { return done; })) {
    lock.unlock();
    look();
    lock.lock();
  }
  lock.unlock();
  worker.join();
  if (thrown) std::rethrow_exception(thrown);
}

void Interrupts::throw_if_interrupted() const {
  if (cancelled_) throw nb::python_error();
}

}  // namespace wend::python
