#include "cli/arguments/option_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "wend/base/parse.hpp"
#include "wend/base/registry.hpp"

namespace wend::cli {
namespace {

constexpr std::size_t kMostOfALine = 45;

std::string dashed(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// "--corner-rule,--corner_rule"
std::string spellings(const std::string& name) {
  const std::string dashes = dashed(name);
  return "--" + dashes + (dashes == name ? "" : ",--" + name);
}

std::string upper_case(std::string text) {
  for (char& letter : text) {
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  }
  return text;
}

bool is_numeric(const OptionInfo& option) {
  return option.kind == OptionKind::integer || option.kind == OptionKind::number;
}

/// What the flag takes: "none|one|both", "N", "NUMBER"; its name if owners differ in choices or these are too many for a
/// line.
std::string type_of(const std::vector<OptionInfo>& options) {
  const OptionInfo& first = options.front();
  const auto all_are = [&options](auto&& property) {
    return std::ranges::all_of(options, property);
  };
  if (!all_are([&](const OptionInfo& own) { return own.choices == first.choices; })) {
    return upper_case(first.name);
  }
  if (all_are([](const OptionInfo& own) { return own.kind == OptionKind::integer; })) return "N";
  if (all_are(is_numeric)) return "NUMBER";
  const std::string choices = fmt::format("{}", fmt::join(first.choices, "|"));
  return choices.size() > kMostOfALine ? upper_case(first.name) : choices;
}

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

/// "default 1; astar, greedy", or the default of each owner where they differ.
std::string defaults_of(const std::vector<std::string>& owners,
                        const std::vector<OptionInfo>& options) {
  const std::string& first = options.front().default_value;
  if (std::ranges::all_of(options, [&](const auto& own) { return own.default_value == first; })) {
    const std::string whose = owners.front().empty() ? "" : "; " + joined(owners);
    return fmt::format("default {}{}", first, whose);
  }
  std::vector<std::string> defaults;
  defaults.reserve(owners.size());
  for (std::size_t i = 0; i < owners.size(); ++i) {
    defaults.push_back(options[i].default_value + " for " + owners[i]);
  }
  return "default " + joined(defaults);
}

/// "what it does; 0 to 10"
std::string words_of(const OptionInfo& option) {
  if (!is_numeric(option)) return option.help;
  return fmt::format("{}; {} to {}", option.help, format_number(option.least),
                     format_number(option.greatest));
}

/// The unit of a number, which its help names after a comma: "m/s" of "the greatest speed, m/s".
std::string_view unit_in(std::string_view help) {
  constexpr std::array<std::string_view, 10> kUnits{"m",       "m/s", "m/s^2", "rad",   "rad/s",
                                                    "rad/s^2", "s",   "1/s",   "1/s^2", "cells"};
  for (std::size_t comma = help.find(", "); comma != std::string_view::npos;
       comma = help.find(", ", comma + 1)) {
    std::string_view rest = help.substr(comma + 2);
    if (rest.starts_with("in ")) rest.remove_prefix(3);
    const std::string_view word = rest.substr(0, rest.find_first_of(" ,;"));
    if (std::ranges::find(kUnits, word) != kUnits.end()) return word;
  }
  return {};
}

/// What is wrong with a value; empty if nothing is, or if the option's owner checks it.
std::string fault_of(const OptionInfo& option, const std::string& value) {
  double number = 0;
  if (option.kind != OptionKind::number) return {};
  return parse_in_range(value, number, option.least, option.greatest, unit_in(option.help));
}

/// What the option does, and its choices unless its type lists them.
std::string help_of(const OptionInfo& option, bool with_choices) {
  const bool listed = with_choices && !option.choices.empty();
  return words_of(option) + (listed ? ": " + or_list(option.choices) : "");
}

/// The first owner's help, then that of owners whose help differs, once for those that share it.
std::string shared_help(const std::vector<std::string>& owners,
                        const std::vector<OptionInfo>& options) {
  const bool with_choices = type_of(options) == upper_case(options.front().name);
  const std::string first = help_of(options.front(), with_choices);
  std::string text = first;
  std::vector<std::pair<std::string, std::vector<std::string>>> others;  // help, whose
  for (std::size_t i = 0; i < owners.size(); ++i) {
    const std::string own = help_of(options[i], with_choices);
    if (own == first) continue;
    auto same = std::ranges::find(others, own, &decltype(others)::value_type::first);
    if (same == others.end()) same = others.insert(same, {own, {}});
    same->second.push_back(owners[i]);
  }
  for (const auto& [help, whose] : others) {
    text += fmt::format("; for {}: {}", fmt::join(whose, " and "), help);
  }
  return wrapped(fmt::format("{} ({})", text, defaults_of(owners, options)));
}

/// "--corner-rule none|one|both" of one owner, and what it does.
std::pair<std::string, std::string> help_line(const OptionInfo& option) {
  const std::string flag = "--" + dashed(option.name);
  const std::string default_text = fmt::format(" (default {})", option.default_value);
  if (option.kind == OptionKind::flag) {
    return {flag + ", --no-" + dashed(option.name), wrapped(option.help + default_text)};
  }
  const std::string type = type_of({option});
  const bool with_choices = type == upper_case(option.name);
  return {flag + " " + type, wrapped(help_of(option, with_choices) + default_text)};
}

}  // namespace

void OptionFlags::collect(const std::string& owner, const std::vector<OptionInfo>& options) {
  owners_.push_back(owner);
  for (const OptionInfo& option : options) {
    auto flag = std::ranges::find(flags_, option.name, &Flag::name);
    if (flag == flags_.end()) flag = flags_.insert(flag, {option.name, option.former, {}, {}});
    flag->owners.push_back(owner);
    flag->options.push_back(option);
  }
}

void OptionFlags::mention(const std::string& owner, const std::vector<OptionInfo>& options) {
  for (const OptionInfo& option : options) mentioned_.emplace_back(owner, option);
}

void OptionFlags::add_to(Parser& app, const std::string& choice) {
  for (const Flag& flag : flags_) add_flag(app, flag);
  if (choice.empty()) return;
  app.add_choice_help(choice, [this](const std::string& text) { return help_of(text); });
}

HelpOfChoice OptionFlags::help_of(const std::string& choice) const {
  const std::string owner = choice.substr(0, choice.find_first_of(":,"));
  if (std::ranges::find(owners_, owner) == owners_.end()) {
    throw InputError(unknown_name(kind_, owner, owners_));
  }
  HelpOfChoice help;
  const auto add = [&](const OptionInfo& option) { help.options.push_back(help_line(option)); };
  for (const Flag& flag : flags_) {
    const auto own = std::ranges::find(flag.owners, owner);
    if (own != flag.owners.end()) {
      add(flag.options[static_cast<std::size_t>(own - flag.owners.begin())]);
    }
  }
  for (const auto& [whose, option] : mentioned_) {
    if (whose == owner) add(option);
  }
  help.title = help.options.empty() ? fmt::format("The {} {} has no options.", kind_, owner)
                                    : fmt::format("Options of the {} {}:", kind_, owner);
  return help;
}

void OptionFlags::add_flag(Parser& app, const Flag& flag) {
  const std::string name = flag.name;
  const std::string help = shared_help(flag.owners, flag.options);
  if (flag.options.front().kind == OptionKind::flag) {
    const auto give = [this, name](std::int64_t count) {
      given_.emplace_back(name, option_text::format(count > 0));
    };
    app.add_flag(spellings(name) + ",!--no-" + dashed(name), give, help).group(group());
    return;
  }
  std::string names = spellings(name);
  for (const std::string& alias : flag.options.front().aliases) names += "," + spellings(alias);
  const auto give = [this, name](const std::string& text) { given_.emplace_back(name, text); };
  const Argument current =
      app.add_option(names, give, help).type_name(type_of(flag.options)).group(group());
  if (flag.former.empty()) return;
  const auto give_former = [this, former = flag.former](const std::string& text) {
    given_.emplace_back(former, text);
  };
  app.add_option(spellings(flag.former), give_former, {})
      .type_name(type_of(flag.options))
      .former_name_of(current);
}

std::string OptionFlags::group() const {
  std::string group = kind_ + " options";
  group[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(group[0])));
  return group;
}

OptionValues OptionFlags::values_for(const std::string& owner) const {
  for (const auto& [name, value] : given_) {
    const Flag& flag = *find(name);
    const std::vector<std::string>& owners = flag.owners;
    const auto own = std::ranges::find(owners, owner);
    if (own != owners.end()) {
      const OptionInfo& option = flag.options[static_cast<std::size_t>(own - owners.begin())];
      const std::string fault = fault_of(option, value);
      if (fault.empty()) continue;
      throw InputError(fmt::format("--{}: {}", dashed(name), fault));
    }
    throw InputError(fmt::format("the {} '{}' has no option --{}; {} {} it", kind_, owner,
                                 dashed(name), joined(owners),
                                 owners.size() == 1 ? "has" : "have"));
  }
  return given_;
}

std::optional<std::string> OptionFlags::given(std::string_view name) const {
  std::optional<std::string> last;
  for (const auto& [option, value] : given_) {
    if (option == name) last = value;
  }
  return last;
}

const OptionFlags::Flag* OptionFlags::find(const std::string& name) const {
  const auto is_called = [&](const Flag& flag) {
    return flag.name == name || (!name.empty() && flag.former == name);
  };
  return &*std::ranges::find_if(flags_, is_called);
}

}  // namespace wend::cli
