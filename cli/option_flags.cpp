#include "option_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "exit_code.hpp"
#include "flags.hpp"
#include "wend/base/parse.hpp"

namespace wend::cli {
namespace {

std::string dashed(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// "--corner-rule,--corner_rule"
std::string spellings(const std::string& name) {
  const std::string dashes = dashed(name);
  return "--" + dashes + (dashes == name ? "" : ",--" + name);
}

/// What the option takes: "none|one|both", "N", "NUMBER".
std::string type_of(const OptionInfo& option) {
  if (option.kind == OptionKind::integer) return "N";
  if (option.kind == OptionKind::number) return "NUMBER";
  std::string type;
  for (const std::string& choice : option.choices) type += (type.empty() ? "" : "|") + choice;
  return type;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

void OptionFlags::collect(const std::string& owner, const std::vector<OptionInfo>& options) {
  for (const OptionInfo& option : options) {
    const auto same_name = [&option](const Flag& flag) { return flag.option.name == option.name; };
    const auto flag = std::find_if(flags_.begin(), flags_.end(), same_name);
    if (flag == flags_.end()) {
      flags_.push_back({option, {owner}, {option.default_value}});
    } else {
      flag->owners.push_back(owner);
      flag->defaults.push_back(option.default_value);
    }
  }
}

void OptionFlags::add_to(CLI::App& app) {
  for (const Flag& flag : flags_) add_flag(app, flag);
}

void OptionFlags::add_flag(CLI::App& app, const Flag& flag) {
  const std::string name = flag.option.name;
  if (flag.option.kind == OptionKind::flag) {
    const auto give = [this, name](std::int64_t count) {
      given_.emplace_back(name, option_text::format(count > 0));
    };
    app.add_flag_function(spellings(name) + ",!--no-" + dashed(name), give, help(flag))
        ->group(group());
    return;
  }
  std::string names = spellings(name);
  for (const std::string& alias : flag.option.aliases) names += "," + spellings(alias);
  const auto give = [this, name](const std::string& text) { given_.emplace_back(name, text); };
  app.add_option_function<std::string>(names, give, help(flag))
      ->type_name(type_of(flag.option))
      ->group(group());
}

std::string OptionFlags::group() const {
  std::string group = kind_ + " options";
  group[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(group[0])));
  return group;
}

std::string OptionFlags::help(const Flag& flag) const {
  const OptionInfo& option = flag.option;
  std::string text = option.help;
  if (option.kind == OptionKind::integer || option.kind == OptionKind::number) {
    text += fmt::format("; {} to {}", format_number(option.least), format_number(option.greatest));
  }
  const bool same_default =
      std::all_of(flag.defaults.begin(), flag.defaults.end(),
                  [&](const auto& value) { return value == flag.defaults[0]; });
  if (same_default) {
    return wrapped(fmt::format("{} (default {}; {})", text, flag.defaults[0], joined(flag.owners)));
  }
  std::vector<std::string> defaults;
  defaults.reserve(flag.owners.size());
  for (std::size_t i = 0; i < flag.owners.size(); ++i) {
    defaults.push_back(flag.defaults[i] + " for " + flag.owners[i]);
  }
  return wrapped(fmt::format("{} (default {})", text, joined(defaults)));
}

OptionValues OptionFlags::values_for(const std::string& owner) const {
  for (const auto& [name, value] : given_) {
    const std::vector<std::string>& owners = find(name)->owners;
    if (std::find(owners.begin(), owners.end(), owner) != owners.end()) continue;
    throw InputError(fmt::format("the {} '{}' has no option --{}; {} {} it", kind_, owner,
                                 dashed(name), joined(owners),
                                 owners.size() == 1 ? "has" : "have"));
  }
  return given_;
}

const OptionFlags::Flag* OptionFlags::find(const std::string& name) const {
  const auto same_name = [&name](const Flag& flag) { return flag.option.name == name; };
  return &*std::find_if(flags_.begin(), flags_.end(), same_name);
}

}  // namespace wend::cli
