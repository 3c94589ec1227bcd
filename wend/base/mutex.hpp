#pragma once

// Mutex: a std::mutex where programs have threads. WebAssembly without threads has no std::mutex, and
// needs none.

#if defined(__wasm__) && !defined(_REENTRANT)

namespace wend {

struct Mutex {
  void lock() {}
  void unlock() {}
};

}  // namespace wend

#else

#include <mutex>

namespace wend {

using Mutex = std::mutex;

}  // namespace wend

#endif

namespace wend {

/// Holds a mutex until the end of the block.
class MutexLock {
 public:
  explicit MutexLock(Mutex& mutex) : mutex_(mutex) { mutex_.lock(); }
  ~MutexLock() { mutex_.unlock(); }
  MutexLock(const MutexLock&) = delete;
  MutexLock& operator=(const MutexLock&) = delete;

 private:
  Mutex& mutex_;
};

}  // namespace wend
