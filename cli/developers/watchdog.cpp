#include "cli/developers/watchdog.hpp"

#include <chrono>
#include <utility>

namespace wend::cli {

Watchdog::Watchdog(double seconds, std::function<void()> overdue)
    : thread_([this, seconds, overdue = std::move(overdue)] { watch(seconds, overdue); }) {}

Watchdog::~Watchdog() {
  change(State::ended);
  thread_.join();
}

void Watchdog::reset() { change(State::waiting); }

void Watchdog::pause() { change(State::paused); }

void Watchdog::change(State state) {
  {
    const std::scoped_lock lock(mutex_);
    state_ = state;
    ++changes_;
  }
  changed_.notify_one();
}

void Watchdog::watch(double seconds, const std::function<void()>& overdue) {
  std::unique_lock lock(mutex_);
  while (state_ != State::ended) {
    const auto is_new = [this, seen = changes_] { return changes_ != seen; };
    if (state_ == State::paused) {
      changed_.wait(lock, is_new);
    } else if (!changed_.wait_for(lock, std::chrono::duration<double>(seconds), is_new)) {
      overdue();
      state_ = State::paused;
    }
  }
}

}  // namespace wend::cli
