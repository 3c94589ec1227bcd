#pragma once

// Converts text to numbers and back, the same in every locale. A parser reads the whole text or fails:
// "12x", " 12" and "" are not numbers.

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "wend/base/compiler.hpp"

namespace wend {

/// A decimal whole number, with a minus sign if the type has one. Nothing for other texts, and for
/// numbers that the type cannot hold.
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
WEND_API std::optional<double> parse_number(std::string_view text);

/// Reads a number in a closed range. Sets `value` and returns an empty text, or returns what is wrong:
/// "'9' is not between 0 and 5 m", "'0,2' is not a number: the decimal point is a dot, did you mean
/// 0.2?". Numbers that a double cannot hold are out of every range.
WEND_API std::string parse_in_range(std::string_view text, double& value, double least,
                                    double greatest, std::string_view unit = {});

/// The shortest text that parse_number reads back as the same number.
WEND_API std::string format_number(double value);

}  // namespace wend
