#include "wend/base/field.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "wend/base/parse.hpp"

namespace wend {

OptionInfo FieldInfo::option() const {
  OptionInfo option{std::string(name),  {}, kind, {}, {}, 0, greatest, std::string(help),
                    std::string(former)};
  if (!alias.empty()) option.aliases.emplace_back(alias);
  if (kind == OptionKind::choice) option.choices.assign(choices.begin(), choices.end());
  if (kind == OptionKind::flag) {
    option.default_value = option_text::format(default_value != 0);
  } else if (kind != OptionKind::choice && !std::isnan(default_value)) {
    option.default_value = format_number(default_value);
  } else if (default_value > 0) {
    option.default_value = choices[static_cast<std::size_t>(default_value) - 1];
  }
  return option;
}

std::optional<Error> FieldInfo::fault_of(double value, std::string_view called) const {
  const bool whole = kind == OptionKind::number || value == std::floor(value);
  if (whole && value >= 0 && value <= greatest) return std::nullopt;
  const std::string text = format_number(value);
  const std::string typed(called.empty() ? name : called);
  if (kind == OptionKind::flag) {
    return option_text::option_error(typed, "'" + text + "' is neither 0 nor 1");
  }
  return option_text::option_error(typed, option_text::fault_of(option(), text));
}

Expected<double, Error> FieldInfo::number_of(std::string_view text) const {
  if (const std::string fault = option_text::fault_of(option(), text); !fault.empty()) {
    return Unexpected<Error>(option_text::option_error(std::string(name), fault));
  }
  if (kind == OptionKind::flag) return text == "true" ? 1.0 : 0.0;
  if (kind != OptionKind::choice) return parse_number(text).value_or(default_value);
  return static_cast<double>(std::ranges::find(choices, text) - choices.begin() + 1);
}

}  // namespace wend
