#include "bench/measure/measuring.hpp"

#include <sched.h>

#include <chrono>

namespace wend::bench {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void stay_on_one_core() {
  const int core = sched_getcpu();
  if (core < 0) return;
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(static_cast<unsigned>(core), &only);
  sched_setaffinity(0, sizeof only, &only);
}

}  // namespace wend::bench
