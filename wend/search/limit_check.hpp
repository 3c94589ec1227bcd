#pragma once

// LimitCheck: checks periodically whether a search must end early.
//
//   if (check.due(expanded)) outcome = check.look(expanded);

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "wend/base/limits.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// The limits of one search, checked before each expansion.
class LimitCheck {
 public:
  /// Starts the clock. `limits` must live as long as the search.
  void begin(const Limits& limits) {
    limits_ = &limits;
    deadline_ = limits.timed() ? limits.now() + limits.seconds : 0;
    next_ = 0;
  }

  /// Is a check due before the next expansion?
  bool due(std::uint64_t expanded) const { return expanded == next_; }

  /// `running`, or why the search must end. Schedules the next check.
  SearchOutcome look(std::uint64_t expanded) {
    next_ = std::min(limits_->expansions, expanded + Limits::kExpansionsBetweenClockReads);
    if (expanded >= limits_->expansions) return SearchOutcome::expansion_limit;
    if (limits_->cancel != nullptr && limits_->cancel->load(std::memory_order_relaxed)) {
      return SearchOutcome::cancelled;
    }
    if (limits_->timed() && limits_->now() > deadline_) return SearchOutcome::time_limit;
    return SearchOutcome::running;
  }

 private:
  const Limits* limits_ = nullptr;
  double deadline_ = 0;
  std::uint64_t next_ = 0;
};

}  // namespace wend
