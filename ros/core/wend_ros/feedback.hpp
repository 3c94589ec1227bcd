#pragma once

// What the actions of planners have in common: Feedback tells how far a search is, every so often,
// while it lives; carry_out() runs a search as an action.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "wend_ros/search_watch.hpp"
#include "wend_ros/status_codes.hpp"

namespace wend_ros {

/// `Message` has expanded, elapsed and best_bound; it may have solutions, cost and bound.
template <class Message, class Publish>
class Feedback {
 public:
  Feedback(const SearchWatch& watch, Publish publish)
      : watch_(watch), publish_(std::move(publish)), teller_([this] { tell(); }) {}
  Feedback(const Feedback&) = delete;
  Feedback& operator=(const Feedback&) = delete;
  ~Feedback() {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    ended_.notify_all();
    teller_.join();
  }

 private:
  /// Between two messages it waits for the end of the search, which is not to wait for it.
  void tell() {
    constexpr auto kPeriod = std::chrono::milliseconds(50);
    const auto begin = std::chrono::steady_clock::now();
    std::unique_lock lock(mutex_);
    while (!done_) {
      Message message;
      message.expanded = watch_.expanded();
      message.elapsed =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      message.best_bound = watch_.f();
      put(watch_.solutions(), message);
      publish_(message);
      ended_.wait_for(lock, kPeriod, [this] { return done_; });
    }
  }

  /// The priorities of an anytime search are weighted: what it has proven counts, once it has a path.
  static void put(const Solutions& solutions, Message& message) {
    if (solutions.count == 0) return;
    if (solutions.bound >= 1) message.best_bound = solutions.cost / solutions.bound;
    if constexpr (requires { message.solutions; }) {
      message.solutions = solutions.count;
      message.cost = solutions.cost;
      message.bound = solutions.bound;
    }
  }

  const SearchWatch& watch_;
  Publish publish_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool done_ = false;
  std::thread teller_;  // last: it uses the others
};

/// Runs `answer(cancel, watch)` for an action's goal, tells how far it is, and ends the action as the
/// status of what it returns says. The preempt callback sets `cancel`.
template <class Result, class Message, class Server, class Answer>
void carry_out(Server& server, std::atomic<bool>& cancel, const Answer& answer) {
  // In this order no preemption is lost that comes in between.
  cancel = false;
  if (server.isPreemptRequested()) cancel = true;
  SearchWatch watch(false);
  Result result;
  {
    const auto publish = [&](const Message& message) { server.publishFeedback(message); };
    const Feedback<Message, decltype(publish)> feedback(watch, publish);
    result.result = answer(&cancel, &watch);
  }
  const auto status = static_cast<StatusCode>(result.result.status);
  if (status == StatusCode::found) {
    server.setSucceeded(result);
  } else if (status == StatusCode::cancelled) {
    server.setPreempted(result, result.result.reason);
  } else {
    server.setAborted(result, result.result.reason);
  }
}

}  // namespace wend_ros
