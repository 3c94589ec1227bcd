#include "wend/base/thread_time.hpp"

#include <chrono>
#include <ctime>

namespace wend {

#if defined(CLOCK_THREAD_CPUTIME_ID) && defined(CLOCK_PROCESS_CPUTIME_ID)

namespace {

double seconds_on(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return std::chrono::duration<double>(std::chrono::seconds(now.tv_sec) +
                                       std::chrono::nanoseconds(now.tv_nsec))
      .count();
}

}  // namespace

double thread_cpu_seconds() { return seconds_on(CLOCK_THREAD_CPUTIME_ID); }

double process_cpu_seconds() { return seconds_on(CLOCK_PROCESS_CPUTIME_ID); }

std::string_view thread_time_name() { return "CPU time"; }

#else

double thread_cpu_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double process_cpu_seconds() { return thread_cpu_seconds(); }

std::string_view thread_time_name() { return "wall time"; }

#endif

}  // namespace wend
