#include "bench/measure/measuring.hpp"

#include <malloc.h>
#include <sched.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

namespace wend::bench {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double resident_bytes() {
  malloc_trim(0);
  std::ifstream pages("/proc/self/statm");
  double all = 0;
  double resident = 0;
  pages >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
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
