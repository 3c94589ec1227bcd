#include "cli/arguments/field_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string>

#include "cli/arguments/flags.hpp"
#include "wend/base/parse.hpp"
#include "wend/io/text.hpp"

namespace wend::cli {
namespace {

constexpr std::string_view kFirstLength = "robot_radius";  // its help says what the others refer to

/// "units as --robot-radius; default 4"
std::string remark_on(const FieldInfo& field) {
  std::string text;
  if (is_length(field)) {
    text = field.name == kFirstLength
               ? "metres, or cells on maps without a resolution and with --cells"
               : "units as --robot-radius";
  }
  const bool has_default = std::isfinite(field.default_value) && field.default_value != 0;
  if (field.kind == OptionKind::flag || !has_default) return text;
  return text + (text.empty() ? "" : "; ") + "default " + field.option().default_value;
}

std::string help_of(const FieldInfo& field) {
  std::string text(field.help);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  const std::string remark = remark_on(field);
  return remark.empty() ? text : fmt::format("{} ({})", text, remark);
}

double number_of(const FieldInfo& field, const std::string& flag, const std::string& text) {
  constexpr double kLargest = 1e9;
  double number = 0;
  if (field.kind == OptionKind::integer) {
    const auto whole = parse_integer<std::uint64_t>(text);
    if (!whole) refuse_value(flag, quote(text) + " is not a whole number of at least 0");
    return static_cast<double>(*whole);
  }
  const std::string wrong = parse_in_range(text, number, 0, std::min(field.greatest, kLargest),
                                           is_length(field) ? kMapUnit : field.unit);
  if (!wrong.empty()) refuse_value(flag, wrong);
  return number;
}

Argument add_flag(Parser& app, const FieldInfo& field, const std::string& flag,
                  const std::string& help, const std::function<void(double)>& take) {
  if (field.kind == OptionKind::flag) {
    return app.add_flag(flag, [take](std::int64_t) { take(1); }, wrapped(help));
  }
  if (field.kind == OptionKind::choice) {
    const auto take_place = [take](std::size_t place) { take(static_cast<double>(place + 1)); };
    return add_word(app, flag, field.option().choices, take_place, help);
  }
  const auto take_text = [&field, flag, take](const std::string& text) {
    take(number_of(field, flag, text));
  };
  return app.add_option(flag, take_text, wrapped(help))
      .type_name(field.kind == OptionKind::integer ? "N" : "NUMBER");
}

std::string dashed(std::string_view name) {
  std::string flag = "--" + std::string(name);
  std::ranges::replace(flag, '_', '-');
  return flag;
}

/// Flags of other names than their field's, and fields without a flag.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kFlags{
    {{"time_limit", "--limit-time"},
     {"expansions", "--limit-expansions"},
     {"goal_tolerance", ""},  // --goal-tolerance has both
     {"goal_heading_tolerance", ""},
     {"keep", ""},        // the command line plans once
     {"explain", ""},     // it always does
     {"from_field", ""},  // `wend field` has the costs
     {"straighten", ""},  // --simplify
     {"spacing", ""}}};   // --resample

}  // namespace

std::string flag_of(const FieldInfo& field) {
  for (const auto& [name, flag] : kFlags) {
    if (field.name == name) return std::string(flag);
  }
  return dashed(field.name);
}

bool is_length(const FieldInfo& field) { return field.unit == "m"; }

Argument add_field(Parser& app, const FieldInfo& field, const std::function<void(double)>& take) {
  const Argument current = add_flag(app, field, flag_of(field), help_of(field), take);
  if (!field.former.empty()) {
    add_flag(app, field, dashed(field.former), {}, take).former_name_of(current);
  }
  return current;
}

}  // namespace wend::cli
