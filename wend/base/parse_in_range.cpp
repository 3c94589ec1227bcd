#include "wend/base/parse_in_range.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "wend/base/parse.hpp"

namespace wend {
namespace {

std::string in_apostrophes(std::string_view text) { return '\'' + std::string(text) + '\''; }

/// A number that a double cannot hold because it is too large: "1e999".
bool is_too_large(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool small =
      text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
  return error == std::errc::result_out_of_range && stop == end && !small;
}

std::string not_a_number(std::string_view text) {
  std::string with_point(text);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  const bool decimal_comma = with_point != text && parse_number(with_point);
  return in_apostrophes(text) + " is not a number" +
         (decimal_comma ? ": the decimal point is a dot, did you mean " + with_point + "?" : "");
}

}  // namespace

std::string parse_in_range(std::string_view text, double& value, double least, double greatest,
                           std::string_view unit) {
  const auto parsed = parse_number(text);
  if ((!parsed && !is_too_large(text)) || (parsed && std::isnan(*parsed))) {
    return not_a_number(text);
  }
  if (!parsed || *parsed < least || *parsed > greatest) {
    return in_apostrophes(text) + " is not between " + format_number(least) + " and " +
           format_number(greatest) + (unit.empty() ? "" : " " + std::string(unit));
  }
  value = *parsed;
  return {};
}

}  // namespace wend
