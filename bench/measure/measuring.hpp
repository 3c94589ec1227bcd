#pragma once

// What every benchmark needs to time things.

namespace wend::bench {

/// Seconds of a monotonic clock, for work that several threads share. All else is measured in CPU
/// time (wend/base/thread_time.hpp).
double wall_seconds();

/// Bytes of memory that this process has in use, after it has given back what it does not use.
double resident_bytes();

/// Keeps this process on the processor that it runs on, as far as the system lets it.
void stay_on_one_core();

}  // namespace wend::bench
