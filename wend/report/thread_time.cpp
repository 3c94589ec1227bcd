#include "wend/report/thread_time.hpp"

#include <chrono>
#include <ctime>

namespace wend {

#ifdef CLOCK_THREAD_CPUTIME_ID

double thread_cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::chrono::duration<double>(std::chrono::seconds(now.tv_sec) +
                                       std::chrono::nanoseconds(now.tv_nsec))
      .count();
}

std::string_view thread_time_name() { return "CPU time"; }

#else

double thread_cpu_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

std::string_view thread_time_name() { return "wall time"; }

#endif

}  // namespace wend
