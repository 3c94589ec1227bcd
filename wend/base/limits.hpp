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
  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
  static constexpr std::uint64_t kExpansionsBetweenClockReads = 256;

  std::uint64_t expansions = kUnlimited;
  double seconds = std::numeric_limits<double>::infinity();
  Clock clock;                                // measures `seconds`; null: the system's steady clock
  const std::atomic<bool>* cancel = nullptr;  // set from another thread to stop the search

  bool timed() const { return clock || seconds < std::numeric_limits<double>::infinity(); }

  /// The time of the clock if timed(), else 0.
  double now() const;
};

}  // namespace wend
