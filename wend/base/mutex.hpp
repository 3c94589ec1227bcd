#pragma once

// Mutex: a std::mutex where programs have threads. WebAssembly without threads has no std::mutex, and
// needs none.

#if defined(__wasm__) && !defined(_REENTRANT)

namespace wend {

/// A lock that does nothing.
struct Mutex {
  void lock() {}    // returns at once
  void unlock() {}  // does nothing
};

}  // namespace wend

#else

#include <mutex>

namespace wend {

/// A lock for one thread at a time.
using Mutex = std::mutex;

}  // namespace wend

#endif

namespace wend {

/// Holds a mutex until the end of the block.
class MutexLock {
 public:
  /// Waits until no other thread holds the mutex.
  explicit MutexLock(Mutex& mutex) : mutex_(mutex) { mutex_.lock(); }
  /// Lets go of the mutex.
  ~MutexLock() { mutex_.unlock(); }
  MutexLock(const MutexLock&) = delete;
  MutexLock& operator=(const MutexLock&) = delete;

 private:
  Mutex& mutex_;
};

}  // namespace wend
