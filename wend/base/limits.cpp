#include "wend/base/limits.hpp"

#include <chrono>

namespace wend {

double Limits::now() const {
  if (clock) return clock();
  if (!timed()) return 0;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace wend
