#pragma once

// A progress bar on standard error, for what takes long. It shows after half a second, goes away
// when the work is done, and is off where standard error is no terminal.

#include <chrono>
#include <cstdint>
#include <string>

namespace wend::cli {

class ProgressBar {
 public:
  /// `total` is how much there is to do, as far as one can tell: work may end earlier, and goes on
  /// without a bar beyond it.
  ProgressBar(std::string label, std::uint64_t total);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(std::uint64_t done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  std::uint64_t total_;
  bool seen_;
  bool drawn_ = false;
  Clock::time_point next_;
};

}  // namespace wend::cli
