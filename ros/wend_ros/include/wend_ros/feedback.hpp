#pragma once

// Feedback: tells how far a search is, every so often, while it lives.

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

#include "wend_ros/search_watch.hpp"
#include "wend_ros/status_codes.hpp"

namespace wend_ros {

/// `Message` has expanded, elapsed and best_bound.
template <class Message, class Publish>
class Feedback {
 public:
  Feedback(const SearchWatch& watch, Publish publish)
      : watch_(watch), publish_(std::move(publish)), teller_([this] { tell(); }) {}
  Feedback(const Feedback&) = delete;
  Feedback& operator=(const Feedback&) = delete;
  ~Feedback() {
    done_ = true;
    teller_.join();
  }

 private:
  void tell() const {
    constexpr auto kPeriod = std::chrono::milliseconds(50);
    const auto begin = std::chrono::steady_clock::now();
    while (!done_) {
      Message message;
      message.expanded = watch_.expanded();
      message.elapsed =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      message.best_bound = watch_.f();
      publish_(message);
      std::this_thread::sleep_for(kPeriod);
    }
  }

  const SearchWatch& watch_;
  Publish publish_;
  std::atomic<bool> done_{false};
  std::thread teller_;
};

/// Ends an action as its result's status says.
template <class Server, class Result>
void finish(Server& server, const Result& result) {
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
