#include "bench/measure/machine.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string_view>
#include <thread>

namespace wend {
namespace {

std::string processor() {
  constexpr std::string_view kModel = "model name";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with(kModel) && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "an unknown processor";
}

std::string compiler() {
#if defined(__clang__)
  return fmt::format("clang {}", __clang_version__);
#else
  return fmt::format("g++ {}", __VERSION__);
#endif
}

}  // namespace

std::string describe_machine() {
  return fmt::format("{}, {} cores; {}", processor(), std::thread::hardware_concurrency(),
                     compiler());
}

}  // namespace wend
