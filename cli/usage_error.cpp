#include "usage_error.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Error.hpp>

#include <vector>

#include "flags.hpp"
#include "wend/base/suggestion.hpp"
#include "wend/io/quote.hpp"

namespace wend::cli {
namespace {

bool is_flag(const std::string& argument) { return argument.size() > 1 && argument[0] == '-'; }

/// "--start" from "--start=1,2"
std::string flag_name_of(const std::string& flag) { return flag.substr(0, flag.find('=')); }

std::vector<std::string> subcommand_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> flag_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The argument that nothing takes; of several, the first flag, since it explains the others.
std::string surplus(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (is_flag(argument)) return argument;
  }
  return arguments.front();
}

/// Where a flag whose value is optional was given without one, how it takes one: what was meant as its
/// value is an argument of its own.
std::string equals_sign_text(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const bool value_is_optional =
        !option->get_type_name().empty() && option->get_items_expected_max() == 0;
    if (!value_is_optional || option->count() == 0 || !option->results().front().empty()) continue;
    return fmt::format("; a value of --{0} is joined by an equals sign, --{0}=VALUE",
                       option->get_lnames().front());
  }
  return {};
}

std::string surplus_text(const CLI::App& app, const std::string& argument) {
  if (is_flag(argument)) {
    const std::string name = flag_name_of(argument);
    const auto closest = closest_name(name, flag_names(app));
    return "there is no flag " + name + (closest ? ": did you mean " + *closest + "?" : "");
  }
  const std::vector<std::string> commands = subcommand_names(app);
  if (commands.empty()) return "unexpected argument " + quote(argument) + equals_sign_text(app);
  const std::string text = "there is no subcommand " + quote(argument);
  const auto closest = closest_name(argument, commands);
  return text + (closest ? ": did you mean " + *closest + "?" : ": choose " + or_list(commands));
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* at = &app;
  std::string command = "wend";
  for (auto parsed = at->get_subcommands(); !parsed.empty(); parsed = at->get_subcommands()) {
    at = parsed.front();
    command += " " + at->get_name();
  }
  const std::vector<std::string> left = at->remaining();
  std::string text = error.what();
  if (!left.empty()) {
    text = surplus_text(*at, surplus(left));
  } else if (!subcommand_names(*at).empty()) {
    text = "choose a subcommand: " + or_list(subcommand_names(*at));
  }
  return fmt::format("{}\n`{} --help` says more", text, command);
}

}  // namespace wend::cli
