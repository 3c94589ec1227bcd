#pragma once

// Lazy: a value that is made when it is first asked for, once for all threads.
//
//   const wend::Grid<double>& costs = costs_.get([&] { return ...; });

#include <atomic>
#include <optional>
#include <utility>

#include "wend/base/mutex.hpp"

namespace wend {

template <class T>
class Lazy {
 public:
  /// Not yet made.
  Lazy() = default;
  /// Copies the value if it has been made.
  Lazy(const Lazy& other) {
    const MutexLock lock(other.mutex_);
    if (other.value_) value_.emplace(*other.value_);
    made_.store(value_.has_value(), std::memory_order_relaxed);
  }
  Lazy& operator=(const Lazy&) = delete;
  ~Lazy() = default;

  /// The value; make() makes it, if nobody has. A thread that asks while another one makes it waits.
  template <class Make>
  const T& get(Make&& make) const {
    if (!made()) {
      const MutexLock lock(mutex_);
      if (!value_) {
        value_.emplace(std::forward<Make>(make)());
        made_.store(true, std::memory_order_release);
      }
    }
    return *value_;  // NOLINT(bugprone-unchecked-optional-access): it has been made
  }

  /// The same where make() may give up: it returns an optional. Null if it did; then nothing has been made.
  template <class Make>
  const T* try_get(Make&& make) const {
    if (!made()) {
      const MutexLock lock(mutex_);
      if (!value_) {
        auto made = std::forward<Make>(make)();
        if (!made) return nullptr;
        value_.emplace(*std::move(made));
        made_.store(true, std::memory_order_release);
      }
    }
    return &*value_;  // NOLINT(bugprone-unchecked-optional-access): it has been made
  }

  /// Has the value been made?
  bool made() const { return made_.load(std::memory_order_acquire); }

  /// The value if it has been made, else null. No other thread may use the object.
  T* changeable() { return value_ ? &*value_ : nullptr; }

  /// Forgets the value. No other thread may use the object.
  void reset() {
    made_.store(false, std::memory_order_relaxed);
    value_.reset();
  }

 private:
  mutable Mutex mutex_;  // guards the making
  mutable std::optional<T> value_;
  mutable std::atomic<bool> made_{false};
};

}  // namespace wend
