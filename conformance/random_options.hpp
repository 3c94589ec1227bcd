#pragma once

// Option values drawn from a schema, good and bad ones.

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/options.hpp"
#include "wend/base/random.hpp"

namespace wend::test {

/// A value that the option takes; numbers of modest size, and the ends of their range.
inline std::string random_value(Random& random, const OptionInfo& option) {
  constexpr double kModest = 2000;
  constexpr std::array kNumbers{0.0, 0.25, 0.5, 1.0, 1.0, 1.5, 2.0, 5.0, 100.0};
  switch (option.kind) {
    case OptionKind::flag:
      return random.chance(0.5) ? "true" : "false";
    case OptionKind::choice:
      return option.choices[random.below(option.choices.size())];
    case OptionKind::integer:
      return std::to_string(random.between(static_cast<int>(std::max(option.least, -kModest)),
                                           static_cast<int>(std::min(option.greatest, kModest))));
    case OptionKind::number:
      break;
  }
  if (random.chance(0.1)) return format_number(random.chance(0.5) ? option.least : option.greatest);
  const double number = kNumbers[random.below(kNumbers.size())];
  return format_number(std::clamp(number, option.least, option.greatest));
}

/// About half of the options given, under their name or an alias. A budget of time never ends a search: what it ends
/// would differ from run to run.
inline OptionValues random_options(Random& random, const std::vector<OptionInfo>& schema) {
  OptionValues values;
  for (const OptionInfo& option : schema) {
    if (option.name == "time_budget") {
      values.emplace_back(option.name, format_number(option.greatest));
      continue;
    }
    if (random.chance(0.4)) continue;
    const bool by_alias = !option.aliases.empty() && random.chance(0.5);
    const std::string& name =
        by_alias ? option.aliases[random.below(option.aliases.size())] : option.name;
    values.emplace_back(name, random_value(random, option));
  }
  return values;
}

/// Texts that an option must refuse.
inline std::vector<std::string> bad_values(const OptionInfo& option) {
  std::vector<std::string> bad{"", " ", "nonsense", "1x", "\xff"};
  if (option.kind == OptionKind::integer || option.kind == OptionKind::number) {
    bad.insert(bad.end(), {"nan", "inf", "-inf", "1e999", "0x10", format_number(option.least - 1),
                           format_number(option.greatest * 2 + 1)});
  }
  if (option.kind == OptionKind::integer) bad.insert(bad.end(), {"1.5", "99999999999999999999"});
  return bad;
}

inline std::string text_of(const OptionValues& values) {
  std::string text;
  for (const auto& [name, value] : values) {
    text += name;
    text += '=';
    text += value;
    text += ' ';
  }
  return text;
}

/// The value of an option: the last one given, else the default; empty if there is no such option.
inline std::string value_of(const std::string& name, const OptionValues& values,
                            const std::vector<OptionInfo>& schema) {
  std::string value;
  for (const OptionInfo& option : schema) {
    if (option.name == name) value = option.default_value;
  }
  for (const auto& [given, text] : values) {
    if (given == name) value = text;
  }
  return value;
}

}  // namespace wend::test
