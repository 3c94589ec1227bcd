#include "wend/base/parse.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wend {
namespace {

/// Parses the whole text. Returns why it is not a number that a double holds, std::errc{} if it is.
std::errc read_number(std::string_view text, double& value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return stop == end ? error : std::errc::invalid_argument;
}

/// Is the text a number that is too large for a double: "1e999"?
bool is_too_large(std::string_view text) {
  double value = 0;
  const bool small =
      text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
  return read_number(text, value) == std::errc::result_out_of_range && !small;
}

std::string in_apostrophes(std::string_view text) { return '\'' + std::string(text) + '\''; }

std::string not_a_number(std::string_view text) {
  std::string with_point(text);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  const bool decimal_comma = with_point != text && parse_number(with_point);
  return in_apostrophes(text) + " is not a number" +
         (decimal_comma ? ": the decimal point is a dot, did you mean " + with_point + "?" : "");
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  if (read_number(text, value) != std::errc{}) return std::nullopt;
  return value;
}

std::string parse_in_range(std::string_view text, double& value, double least, double greatest,
                           std::string_view unit) {
  const auto parsed = parse_number(text);
  if (parsed ? std::isnan(*parsed) : !is_too_large(text)) return not_a_number(text);
  if (!parsed || *parsed < least || *parsed > greatest) {
    return in_apostrophes(text) + " is not between " + format_number(least) + " and " +
           format_number(greatest) + (unit.empty() ? "" : " " + std::string(unit));
  }
  value = *parsed;
  return {};
}

std::string format_number(double value) {
  std::array<char, 32> buffer{};  // the longest shortest double has 24 characters
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string{};
}

}  // namespace wend
