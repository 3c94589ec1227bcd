#include "cli/arguments/usage_error.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Error.hpp>

#include <algorithm>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/parser.hpp"
#include "wend/base/registry.hpp"
#include "wend/io/text.hpp"

namespace wend::cli {
namespace {

bool is_flag(const std::string& argument) { return argument.size() > 1 && argument[0] == '-'; }

/// "--start" from "--start=1,2"
std::string flag_name_of(const std::string& flag) { return flag.substr(0, flag.find('=')); }

std::vector<std::string> subcommand_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : visible_subcommands(app)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> shown_flags(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // a former name
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The argument that is not accepted; of several, the first flag, since it explains the others.
std::string surplus(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (is_flag(argument)) return argument;
  }
  return arguments.front();
}

std::string needs_value(const CLI::Option& option) {
  return fmt::format("{} needs a value: {}", option.get_name(), option.get_type_name());
}

/// If a flag was given without its optional value, how to give the value: the intended value was read
/// as a separate argument.
std::string equals_sign_text(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const bool value_is_optional =
        !option->get_type_name().empty() && option->get_items_expected_max() == 0;
    if (!value_is_optional || option->count() == 0 || !option->results().front().empty()) continue;
    return fmt::format("; the value of --{0} needs an equals sign, --{0}=VALUE",
                       option->get_lnames().front());
  }
  return {};
}

/// "--start needs a value: X,Y", where the next flag was taken for the value of one.
std::string swallowed_flag_text(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& value : option->results()) {
      const bool is_long = value.starts_with("--");
      if (is_long && app.get_option_no_throw(flag_name_of(value)) != nullptr) {
        return needs_value(*option);
      }
    }
  }
  return {};
}

/// Where two arguments exclude each other: mostly one is the former name of the other.
std::string excluded_text(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0) continue;
    for (const CLI::Option* other : option->get_excludes()) {
      if (other->count() == 0 || other->get_group().empty()) continue;
      const auto text = option->get_group().empty()
                            ? "--{} is the former name of --{}: give one of them"
                            : "--{} and --{} cannot both be given";
      return fmt::format(fmt::runtime(text), option->get_lnames().front(),
                         other->get_lnames().front());
    }
  }
  return {};
}

/// A flag without its value, or one that was given too often.
std::string mismatch_text(const CLI::App& app, const CLI::ArgumentMismatch& error) {
  std::string what = error.what();  // "--start: 1 required X,Y missing"
  const std::string name = what.substr(0, what.find(':'));
  const CLI::Option* option = app.get_option_no_throw(name);
  if (option == nullptr) return what;
  if (option->results().size() > 1) {
    return fmt::format("{} is given {} times but takes one value", name, option->results().size());
  }
  return needs_value(*option);
}

std::string surplus_text(const CLI::App& app, const std::string& argument) {
  if (is_flag(argument)) {
    const std::string name = flag_name_of(argument);
    const auto closest = closest_name(name, shown_flags(app));
    return "unknown option " + name + (closest ? ": did you mean " + *closest + "?" : "");
  }
  const std::vector<std::string> commands = subcommand_names(app);
  if (commands.empty()) return "unexpected argument " + quote(argument) + equals_sign_text(app);
  const std::string text = "unknown subcommand " + quote(argument);
  const auto closest = closest_name(argument, commands);
  return text + (closest ? ": did you mean " + *closest + "?" : ": choose " + or_list(commands));
}

/// The subcommand that was named last, or the program.
const CLI::App& innermost(const CLI::App& app) {
  const CLI::App* at = &app;
  for (auto parsed = at->get_subcommands(); !parsed.empty(); parsed = at->get_subcommands()) {
    at = parsed.front();
  }
  return *at;
}

std::string with_help(const CLI::App& command, const std::string& text) {
  std::string name = command.get_name();
  for (const CLI::App* above = command.get_parent(); above != nullptr;
       above = above->get_parent()) {
    name.insert(0, above->get_name() + " ");
  }
  return fmt::format("{}\nsee `{} --help`", text, name);
}

}  // namespace

std::string swallowed_flag(const CLI::App& app) {
  const CLI::App& command = innermost(app);
  const std::string text = swallowed_flag_text(command);
  return text.empty() ? text : with_help(command, text);
}

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* at = &innermost(app);
  const std::vector<std::string> left = at->remaining();
  std::string text = swallowed_flag_text(*at);
  if (!text.empty()) return with_help(*at, text);
  text = error.what();
  if (!left.empty()) {
    text = surplus_text(*at, surplus(left));
  } else if (const auto* mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    text = mismatch_text(*at, *mismatch);
  } else if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) {
    text = excluded_text(*at);
  } else if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr &&
             !subcommand_names(*at).empty()) {
    text = "choose a subcommand: " + or_list(subcommand_names(*at));
  }
  return with_help(*at, text);
}

}  // namespace wend::cli
