#pragma once

// Deadline: the limit on time and the cancel flag of a whole call, which has more parts than a search.
//
//   const wend::Deadline deadline(request.limits);   // the time begins
//   query.limits = deadline.left();                  // for a search
//   if (deadline.passed()) return deadline.status(); // elsewhere

#include <cstdint>
#include <limits>
#include <string>

#include "wend/base/compiler.hpp"
#include "wend/base/limits.hpp"
#include "wend/base/status.hpp"

namespace wend {

class WEND_API Deadline {
 public:
  /// Never passes.
  Deadline() = default;
  /// Passes when the limit on time ends, counted from now, or the cancel flag is set.
  explicit Deadline(const Limits& limits);

  /// Can it pass?
  bool bounded() const;
  /// Has it passed? Reads the clock, if there is one.
  bool passed() const;
  /// Why it passed: cancelled or time_limit.
  Status status() const;
  /// Seconds until it passes; infinite without a limit on time.
  double seconds_left() const;
  /// The limits for the rest of the call.
  Limits left() const;
  /// The same without the cancel flag.
  Deadline without_cancel() const;
  /// The same, but that time ends some seconds later.
  Deadline later(double seconds) const;
  /// "stopped after 0.01 s" or "cancelled".
  std::string text() const;

 private:
  bool cancelled() const;

  Limits limits_ = {};
  double end_ = std::numeric_limits<double>::infinity();
};

/// Asks a deadline now and then, for loops over cells; once it has passed, it stays so. What such a loop was to make is
/// incomplete if has_passed() afterwards, and of no use.
class DeadlineCheck {
 public:
  /// One that never passes. Threads may share it.
  static DeadlineCheck& never() {
    static DeadlineCheck shared;
    return shared;
  }

  /// The deadline must outlive it; null: it never passes.
  explicit DeadlineCheck(const Deadline* deadline = nullptr)
      : deadline_(deadline != nullptr && deadline->bounded() ? deadline : nullptr) {}

  /// Must the loop end? Looks at every kEvery-th call.
  bool operator()() {
    if (deadline_ == nullptr) return false;
    if (!passed_ && ++calls_ % kEvery == 0) passed_ = deadline_->passed();
    return passed_;
  }
  /// The same, and looks at once.
  bool now() {
    if (deadline_ != nullptr && !passed_) passed_ = deadline_->passed();
    return passed_;
  }
  /// Has it said that a loop must end?
  bool has_passed() const { return passed_; }
  /// The deadline; null if it never passes.
  const Deadline* deadline() const { return deadline_; }

 private:
  static constexpr std::uint32_t kEvery = 1024;

  const Deadline* deadline_;
  std::uint32_t calls_ = 0;
  bool passed_ = false;
};

}  // namespace wend
