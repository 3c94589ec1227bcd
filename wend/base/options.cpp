#include "wend/base/options.hpp"

#include <algorithm>

#include "wend/base/parse_in_range.hpp"
#include "wend/base/suggestion.hpp"

namespace wend {
namespace {

std::string quoted(std::string_view text) { return '\'' + std::string(text) + '\''; }

std::string out_of_range(std::string_view text, OptionRange range) {
  return quoted(text) + " is not between " + format_number(range.least) + " and " +
         format_number(range.greatest);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return text;
}

}  // namespace

std::string_view to_string(OptionKind kind) {
  switch (kind) {
    case OptionKind::flag:
      return "flag";
    case OptionKind::integer:
      return "integer";
    case OptionKind::number:
      return "number";
    case OptionKind::choice:
      return "choice";
  }
  return {};
}

namespace option_text {

std::string parse(std::string_view text, bool& value) {
  if (text != "true" && text != "false") return quoted(text) + " is neither true nor false";
  value = text == "true";
  return {};
}

std::string parse(std::string_view text, std::int64_t& value, OptionRange range) {
  const auto parsed = parse_integer<std::int64_t>(text);
  if (!parsed) {
    const bool too_large = parse_number(text).has_value() &&
                           text.find_first_not_of("+-0123456789") == std::string_view::npos;
    return too_large ? out_of_range(text, range) : quoted(text) + " is not a whole number";
  }
  const auto number = static_cast<double>(*parsed);
  if (number < range.least || number > range.greatest) return out_of_range(text, range);
  value = *parsed;
  return {};
}

std::string parse(std::string_view text, double& value, OptionRange range) {
  return parse_in_range(text, value, range.least, range.greatest);
}

std::string unknown_choice(std::string_view text, const std::vector<std::string>& choices) {
  return quoted(text) + " is not one of " + listed(choices);
}

OptionError unknown_option(std::string_view name, const std::vector<std::string>& known) {
  if (known.empty()) return {std::string(name), "there are no options here"};
  if (const auto closest = closest_name(name, known)) {
    return {std::string(name), "there is no such option: did you mean '" + *closest + "'?"};
  }
  return {std::string(name), "there is no such option: choose from " + listed(known)};
}

std::string format(bool value) { return value ? "true" : "false"; }

}  // namespace option_text

OptionInfo& SchemaBuilder::add(const OptionText& text, OptionKind kind, std::string default_value,
                               OptionRange range) {
  std::vector<std::string> aliases;
  for (const std::string_view alias : text.aliases) {
    if (!alias.empty()) aliases.emplace_back(alias);
  }
  return schema_.emplace_back(OptionInfo{std::string(text.name),
                                         std::move(aliases),
                                         kind,
                                         std::move(default_value),
                                         {},
                                         range.least,
                                         range.greatest,
                                         std::string(text.help),
                                         std::string(text.former)});
}

std::optional<OptionError> OptionParser::error() const {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& [name, text] : values_) {
    if (!has(known_, name) && !has(former_, name)) return option_text::unknown_option(name, known_);
  }
  return bad_value_;
}

}  // namespace wend
