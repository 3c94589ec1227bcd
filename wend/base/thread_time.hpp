#pragma once

// CPU time of a thread, and the one rule by which times are measured.
//
//   const wend::Clock clock = wend::thread_cpu_seconds;
//   const double first = wend::seconds_of(clock, [&] { planner->plan(query, plan); });
//   const double later = wend::least_seconds(clock, [&] { planner->plan(query, plan); });
//
// On a busy machine wall time includes the work of other processes; CPU time does not. Remaining
// disturbances, such as caches that other processes emptied, only add time, so the fastest of several
// runs is the best estimate of the cost.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/limits.hpp"

namespace wend {

/// CPU seconds that the calling thread has used so far, in user and in kernel mode. Falls back to
/// seconds of the monotonic clock where the system has no CLOCK_THREAD_CPUTIME_ID (POSIX).
WEND_API double thread_cpu_seconds();

/// CPU seconds of all threads of the program, for work that threads share. Has the same fallback.
WEND_API double process_cpu_seconds();

/// What these clocks count on this system: "CPU time", or "wall time" if they fall back.
WEND_API std::string_view thread_time_name();

/// How often a measured function runs.
struct RepetitionRule {
  double fill_seconds = 5e-3;  // runs are repeated until they take this long in total
  /// Shorter runs are timed several at a time, because reading the clock takes up to a microsecond.
  double shortest_seconds = 50e-6;
  std::uint64_t most_runs = std::uint64_t{1} << 14U;  // regardless of the clock
};

/// The seconds of one run.
template <class Run>
double seconds_of(const Clock& clock, Run&& run) {
  const double begin = clock();
  run();
  return clock() - begin;
}

/// Runs a function that returns a result, and adds its time to `seconds`.
template <class Run>
auto timed(const Clock& clock, double& seconds, Run&& run) {
  const double begin = clock();
  auto result = run();
  seconds += clock() - begin;
  return result;
}

/// The time of the fastest run, among runs that fill the rule's time. A function that takes longer runs
/// once. For runs that are timed together, the mean counts.
template <class Run>
double least_seconds(const Clock& clock, Run&& run, const RepetitionRule& rule = {}) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double least = kNone;
  double total = 0;
  std::uint64_t runs = 0;
  std::uint64_t together = 1;
  do {
    const double seconds = seconds_of(clock, [&] {
      for (std::uint64_t i = 0; i < together; ++i) run();
    });
    total += seconds;
    runs += together;
    if (seconds >= rule.shortest_seconds) {
      least = std::min(least, seconds / static_cast<double>(together));
    } else {
      together *= 2;
    }
  } while (total < rule.fill_seconds && runs < rule.most_runs);
  return least < kNone ? least : total / static_cast<double>(runs);
}

}  // namespace wend
