#include "wend/render/heatmap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace wend {
namespace {

constexpr int kMostDecimals = 2;
constexpr double kLong = 1e6;  // from here on with an exponent

// Sums of square roots are whole numbers only up to rounding.
constexpr double kRounding = 1e-9;

bool whole(double number) {
  return std::abs(number - std::round(number)) <= kRounding * std::max(1.0, std::abs(number));
}

}  // namespace

double HeatRange::share(double value) const {
  if (!(least < greatest)) return 0;
  // Halves, as the whole span may be more than a double holds.
  return std::clamp((value / 2 - least / 2) / (greatest / 2 - least / 2), 0.0, 1.0);
}

std::optional<HeatRange> range_of(const Heatmap& heatmap) {
  std::optional<HeatRange> range = heatmap.range;
  if (range) return range;
  for (const double value : heatmap.values.values()) {
    if (!std::isfinite(value)) continue;
    if (!range) range = {value, value};
    range->least = std::min(range->least, value);
    range->greatest = std::max(range->greatest, value);
  }
  return range;
}

std::string short_number(double number) {
  if (whole(number) && std::abs(number) < kLong) return fmt::format("{:.0f}", number + 0.0);
  if (std::abs(number) >= 1000 && std::abs(number) < kLong) return fmt::format("{:.0f}", number);
  std::string text = fmt::format("{:.3g}", number);
  for (const auto& [longer, shorter] : {std::pair("e+0", "e"), {"e-0", "e-"}, {"e+", "e"}}) {
    if (const auto at = text.find(longer); at != std::string::npos) {
      text.replace(at, std::string_view(longer).size(), shorter);
    }
  }
  return text;
}

NumberText::NumberText(const Grid<double>& numbers) {
  for (const double number : numbers.values()) {
    while (decimals_ < kMostDecimals && std::isfinite(number) &&
           !whole(number * std::pow(10, decimals_))) {
      ++decimals_;
    }
  }
  for (const double number : numbers.values()) {
    if (!std::isfinite(number)) continue;
    columns_ = std::max(columns_, static_cast<int>((*this)(number).size()));
  }
}

std::string NumberText::operator()(double number) const {
  return fmt::format("{:.{}f}", number, decimals_);
}

}  // namespace wend
