#include "wend/render/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wend {
namespace {

constexpr int kMostDecimals = 2;
constexpr double kLong = 1e6;  // from here on with an exponent

// Sums of square roots are whole numbers only up to rounding.
constexpr double kRounding = 1e-9;

bool whole(double number) {
  return std::abs(number - std::round(number)) <= kRounding * std::max(1.0, std::abs(number));
}

/// The least number of decimals that shows all numbers exactly, or kMostDecimals.
int decimals_of(const Grid<double>& numbers) {
  int decimals = 0;
  double factor = 1;
  for (const double number : numbers.values()) {
    while (decimals < kMostDecimals && std::isfinite(number) && !whole(number * factor)) {
      ++decimals;
      factor *= 10;
    }
  }
  return decimals;
}

}  // namespace

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

NumberText::NumberText(const Grid<double>& numbers) : decimals_(decimals_of(numbers)) {
  for (const double number : numbers.values()) {
    if (!std::isfinite(number)) continue;
    columns_ = std::max(columns_, static_cast<int>((*this)(number).size()));
  }
}

std::string NumberText::operator()(double number) const {
  return fmt::format("{:.{}f}", number, decimals_);
}

}  // namespace wend
