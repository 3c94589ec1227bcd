#pragma once

// The limits of a query, and its cancel flag.

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>

#include "wend/base/compiler.hpp"

namespace wend {

/// Seconds since some fixed moment, never decreasing.
using Clock = std::function<double()>;

/// The system's steady clock.
WEND_API double steady_seconds();

/// Limits of one query. A search checks `expansions` before every expansion. It checks the clock
/// and the cancel flag at its start and then every kExpansionsBetweenClockReads expansions (some
/// ten microseconds).
struct WEND_API Limits {
  /// The value of `expansions` without a limit.
  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
  /// How often a search reads the clock and the cancel flag.
  static constexpr std::uint64_t kExpansionsBetweenClockReads = 256;

  std::uint64_t expansions = kUnlimited;                     // the most states to expand
  double seconds = std::numeric_limits<double>::infinity();  // measured by `clock`
  Clock clock;                                // measures `seconds`; null: the system's steady clock
  const std::atomic<bool>* cancel = nullptr;  // set from another thread to stop the search

  /// Is there a clock or a limit on the time?
  bool timed() const { return clock || seconds < std::numeric_limits<double>::infinity(); }

  /// The time of the clock if timed(), else 0.
  double now() const;
};

}  // namespace wend
