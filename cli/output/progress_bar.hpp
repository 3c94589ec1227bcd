#pragma once

// A progress bar on standard error for long work. It appears after half a second, disappears when the
// work is done, and is off if standard error is not a terminal.

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace wend::cli {

class ProgressBar {
 public:
  /// `total` is the estimated amount of work: the work may end earlier, and continues without a bar
  /// beyond it.
  ProgressBar(std::string_view label, std::uint64_t total);
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
