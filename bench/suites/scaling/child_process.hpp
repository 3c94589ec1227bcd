#pragma once

// Work in a child process, so that its memory is its own.

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>

namespace wend::bench {

/// The process's private memory in bytes.
inline std::uint64_t private_bytes() {
  constexpr std::uint64_t kKilobyte = 1024;
  std::uint64_t kilobytes = 0;
  std::ifstream file("/proc/self/smaps_rollup");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    std::uint64_t value = 0;
    if (words >> name >> value && name.starts_with("Private_")) kilobytes += value;
  }
  return kKilobyte * kilobytes;
}

/// The result of `work()`, computed in a child process; nothing if the child died.
template <class Work>
auto in_child(Work&& work) -> std::optional<std::invoke_result_t<Work>> {
  using Result = std::invoke_result_t<Work>;
  static_assert(std::is_trivially_copyable_v<Result>);
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child == 0) {
    const Result result = work();
    const bool sent = write(ends[1], &result, sizeof result) == sizeof result;
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  Result result{};
  const bool received = child > 0 && read(ends[0], &result, sizeof result) == sizeof result;
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return received ? std::optional(result) : std::nullopt;
}

}  // namespace wend::bench
