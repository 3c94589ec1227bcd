#pragma once

// Watchdog: ends what hangs in foreign code, which cannot be interrupted.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace wend::cli {

class Watchdog {
 public:
  /// Calls `overdue`, on a thread of its own, when reset() was last called `seconds` of wall time ago. It should end the
  /// program: pause() and reset() wait until it returns.
  Watchdog(double seconds, std::function<void()> overdue);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// The time begins again.
  void reset();
  /// Until the next reset().
  void pause();

 private:
  enum class State { waiting, paused, ended };

  void watch(double seconds, const std::function<void()>& overdue);
  void change(State state);

  std::mutex mutex_;
  std::condition_variable changed_;
  State state_ = State::paused;
  unsigned changes_ = 0;
  std::thread thread_;
};

}  // namespace wend::cli
