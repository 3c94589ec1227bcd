#pragma once

// What every benchmark needs to time things.

namespace wend::bench {

/// Seconds since some fixed moment, never going back.
double seconds_now();

/// Keeps this process on the processor that it runs on, as far as the system lets it.
void stay_on_one_core();

}  // namespace wend::bench
