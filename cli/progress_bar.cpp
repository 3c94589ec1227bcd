#include "progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "terminal.hpp"

namespace wend::cli {
namespace {

using std::chrono_literals::operator""ms;

constexpr auto kDelay = 500ms;
constexpr auto kInterval = 100ms;
constexpr std::size_t kWidth = 24;

void write(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

ProgressBar::ProgressBar(std::string label, std::uint64_t total)
    : label_(std::move(label)),
      total_(std::max<std::uint64_t>(total, 1)),
      seen_(progress_is_seen()),
      next_(Clock::now() + kDelay) {}

ProgressBar::~ProgressBar() {
  if (drawn_) write("\r\x1b[K");
}

void ProgressBar::update(std::uint64_t done) {
  if (!seen_ || Clock::now() < next_) return;
  next_ = Clock::now() + kInterval;
  drawn_ = true;
  const double share = std::min(static_cast<double>(done) / static_cast<double>(total_), 1.0);
  const auto filled = static_cast<std::size_t>(share * kWidth);
  write(fmt::format("\r{} [{:<{}}] {:3.0f} % ({} of {})\x1b[K", label_, std::string(filled, '#'),
                    kWidth, 100 * share, done, total_));
}

}  // namespace wend::cli
