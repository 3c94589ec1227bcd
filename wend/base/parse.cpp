#include "wend/base/parse.hpp"

#include <algorithm>
#include <cmath>

#include "wend/base/number_text.hpp"

namespace wend {
namespace {

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
    const std::string range = std::isinf(greatest) ? " is less than " + format_number(least)
                                                   : " is not between " + format_number(least) +
                                                         " and " + format_number(greatest);
    return in_apostrophes(text) + range + (unit.empty() ? "" : " " + std::string(unit));
  }
  value = *parsed;
  return {};
}

std::string format_number(double value) { return shortest_text(value); }

}  // namespace wend
