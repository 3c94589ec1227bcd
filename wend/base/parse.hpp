#pragma once

// Text to numbers and back, the same in every locale. A parser takes the whole text or nothing:
// "12x", " 12" and "" are no numbers.

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace wend {

template <std::integral Integer>
std::optional<Integer> parse_integer(std::string_view text) {
  Integer value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || text.empty()) return std::nullopt;
  return value;
}

/// Decimal or exponent notation, "inf" and "nan" included: check std::isfinite where it matters.
/// Nothing for numbers that a double cannot hold (1e999).
std::optional<double> parse_number(std::string_view text);

/// The shortest text that parse_number reads back as the same number.
std::string format_number(double value);

}  // namespace wend
