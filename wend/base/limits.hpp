#pragma once

// What a query may use before it gives up, and how it is told to stop.

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>

namespace wend {

/// Seconds since some fixed moment, never going back. Passed in, so that the library reads no
/// clock of its own and tests can make time pass as they like.
using Clock = std::function<double()>;

/// Limits of one query. A search looks at `expansions` before every expansion, at the clock and the
/// cancel flag at its start and then every kExpansionsBetweenClockReads expansions (some ten
/// microseconds).
struct Limits {
  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
  static constexpr std::uint64_t kExpansionsBetweenClockReads = 256;

  std::uint64_t expansions = kUnlimited;
  double seconds = std::numeric_limits<double>::infinity();
  Clock clock;  // needed for `seconds`; without one it is not looked at
  const std::atomic<bool>* cancel = nullptr;  // set from another thread to stop the search
};

}  // namespace wend
