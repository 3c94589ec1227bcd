#include "wend/base/cpu_time.hpp"

#include <ctime>

#include "wend/base/limits.hpp"

namespace wend {

double cpu_seconds() {
#if defined(CLOCK_THREAD_CPUTIME_ID)
  timespec now{};
  constexpr double kPerNanosecond = 1e-9;
  if (::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0) {
    return static_cast<double>(now.tv_sec) + kPerNanosecond * static_cast<double>(now.tv_nsec);
  }
#endif
  return steady_seconds();
}

}  // namespace wend
