#include "wend/base/options.hpp"

#include "wend/base/registry.hpp"

namespace wend {
namespace {

std::string quoted(std::string_view text) { return '\'' + std::string(text) + '\''; }

Unexpected<Error> refused(std::string what) {
  return failure(Status::invalid_option, std::move(what));
}

/// Cuts off and returns the text before the first separator, or all of it.
std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return taken;
}

/// Adds "name=value" to the options; false if it is not of that form.
bool add_option(std::string_view word, OptionSpec& spec) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos || equals == 0) return false;
  spec.options.emplace_back(word.substr(0, equals), word.substr(equals + 1));
  return true;
}

}  // namespace

std::string_view to_string(OptionKind kind) {
  constexpr std::array<Choice<OptionKind>, 4> kNames{{{"flag", OptionKind::flag},
                                                      {"integer", OptionKind::integer},
                                                      {"number", OptionKind::number},
                                                      {"choice", OptionKind::choice}}};
  return choice_name(kind, kNames);
}

namespace option_text {

std::string parse(std::string_view text, bool& value, OptionRange /*range*/) {
  if (text != "true" && text != "false") return quoted(text) + " is neither true nor false";
  value = text == "true";
  return {};
}

std::string parse(std::string_view text, std::int64_t& value, OptionRange range) {
  const auto parsed = parse_integer<std::int64_t>(text);
  const bool too_large = parse_number(text).has_value() &&
                         text.find_first_not_of("+-0123456789") == std::string_view::npos;
  if (!parsed && !too_large) return quoted(text) + " is not a whole number";
  double number = 0;
  std::string wrong = parse_in_range(text, number, range.least, range.greatest);
  if (wrong.empty()) value = parsed.value_or(value);
  return wrong;
}

std::string parse(std::string_view text, double& value, OptionRange range) {
  return parse_in_range(text, value, range.least, range.greatest);
}

std::string fault_of(const OptionInfo& option, std::string_view text) {
  const OptionRange range{option.least, option.greatest};
  switch (option.kind) {
    case OptionKind::flag: {
      bool value = false;
      return parse(text, value);
    }
    case OptionKind::integer: {
      std::int64_t value = 0;
      return parse(text, value, range);
    }
    case OptionKind::number: {
      double value = 0;
      return parse(text, value, range);
    }
    case OptionKind::choice:
      break;
  }
  const bool known =
      std::find(option.choices.begin(), option.choices.end(), text) != option.choices.end();
  return known ? std::string() : unknown_choice(text, option.choices);
}

std::string unknown_choice(std::string_view text, const std::vector<std::string>& choices) {
  return quoted(text) + " is not one of " + listed(choices);
}

Error option_error(const std::string& option, const std::string& what) {
  return {Status::invalid_option, "option '" + option + "': " + what, option};
}

Error unknown_option(std::string_view name, const std::vector<std::string>& known) {
  Error error = option_error(std::string(name),
                             known.empty() ? "there are no options" : suggestion(name, known));
  error.message.insert(0, "unknown ");
  return error;
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

std::optional<Error> OptionParser::error() const {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& [name, text] : values_) {
    if (!has(known_, name) && !has(former_, name)) return option_text::unknown_option(name, known_);
  }
  return bad_value_;
}

Expected<std::vector<OptionSpec>, Error> parse_option_specs(std::string_view list,
                                                            std::string_view kind,
                                                            const std::vector<std::string>& names) {
  if (list.empty()) return refused("no " + std::string(kind) + " is named");
  std::vector<OptionSpec> specs;
  bool more = true;
  while (more) {
    more = list.find(',') != std::string_view::npos;
    const std::string_view word = take_until(list, ',');
    std::string_view rest = word;
    const std::string_view name = take_until(rest, ':');
    const bool continues = !specs.empty() && name.find('=') != std::string_view::npos;
    if (continues) {
      specs.back().text.append(",").append(word);
      if (!add_option(word, specs.back())) return refused(quoted(word) + " is no option");
      continue;
    }
    if (std::ranges::find(names, name) == names.end()) {
      return refused(unknown_name(kind, name, names));
    }
    specs.push_back({std::string(name), {}, std::string(word)});
    if (word.size() > name.size() && !add_option(rest, specs.back())) {
      return refused(quoted(rest) + " in " + quoted(word) + " is not of the form option=value");
    }
  }
  return specs;
}

}  // namespace wend
