#include "wend/base/deadline.hpp"

#include <algorithm>

#include "wend/base/parse.hpp"

namespace wend {

Deadline::Deadline(const Limits& limits)
    : limits_(limits),
      end_(limits.timed() ? limits.now() + limits.seconds
                          : std::numeric_limits<double>::infinity()) {}

bool Deadline::bounded() const { return limits_.cancel != nullptr || limits_.timed(); }

bool Deadline::cancelled() const {
  return limits_.cancel != nullptr && limits_.cancel->load(std::memory_order_relaxed);
}

bool Deadline::passed() const {
  if (cancelled()) return true;
  // A clock may set the flag.
  return limits_.timed() && (limits_.now() > end_ || cancelled());
}

Status Deadline::status() const { return cancelled() ? Status::cancelled : Status::time_limit; }

double Deadline::seconds_left() const {
  // An end that is NaN comes from limits that a planner refuses.
  if (!(end_ < std::numeric_limits<double>::infinity())) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(0.0, end_ - limits_.now());
}

Limits Deadline::left() const {
  Limits left = limits_;
  if (end_ < std::numeric_limits<double>::infinity()) left.seconds = seconds_left();
  return left;
}

Deadline Deadline::without_cancel() const {
  Deadline other = *this;
  other.limits_.cancel = nullptr;
  return other;
}

Deadline Deadline::later(double seconds) const {
  Deadline other = *this;
  other.end_ += seconds;
  return other;
}

std::string Deadline::text() const {
  return cancelled() ? "cancelled" : "stopped after " + format_number(limits_.seconds) + " s";
}

}  // namespace wend
