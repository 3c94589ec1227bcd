#include "cli/output/progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "cli/output/terminal.hpp"
#include "wend/io/text.hpp"

namespace wend::cli {
namespace {

using std::chrono_literals::operator""ms;

constexpr auto kDelay = 500ms;
constexpr auto kInterval = 100ms;
constexpr std::size_t kWidth = 24;
constexpr const char* kClear = "\x1b[K";  // the rest of the line

void write(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

/// " [######      ]  50 % (3 of 6)"
std::string bar(std::uint64_t done, std::uint64_t total) {
  const double share = static_cast<double>(done) / static_cast<double>(total);
  const auto filled = static_cast<std::size_t>(share * kWidth);
  return fmt::format(" [{:<{}}] {:3.0f} % ({} of {})", std::string(filled, '#'), kWidth,
                     100 * share, done, total);
}

}  // namespace

ProgressBar::ProgressBar(std::string_view label, std::uint64_t total)
    : label_(visible(label)),
      total_(std::max<std::uint64_t>(total, 1)),
      seen_(progress_is_seen()),
      next_(Clock::now() + kDelay) {}

ProgressBar::~ProgressBar() {
  if (drawn_) write(std::string("\r") + kClear);
}

void ProgressBar::update(std::uint64_t done) {
  if (!seen_ || Clock::now() < next_) return;
  next_ = Clock::now() + kInterval;
  drawn_ = true;
  write("\r" + label_ + (done <= total_ ? bar(done, total_) : fmt::format(" {}", done)) + kClear);
}

}  // namespace wend::cli
