#include "wend/base/limits.hpp"

#include <chrono>

namespace wend {

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double Limits::now() const {
  if (clock) return clock();
  return timed() ? steady_seconds() : 0;
}

}  // namespace wend
