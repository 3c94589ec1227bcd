// wend: the command line, and wend-bench, which has the developers' commands besides. This file makes the app from
// its subcommands, and turns what goes wrong into messages and exit codes.

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/arguments/help_formatter.hpp"
#include "cli/arguments/plugins.hpp"
#include "cli/arguments/usage_error.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/developer_commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/output/output.hpp"
#include "wend/version.hpp"

namespace {

using namespace wend::cli;

constexpr int kNameColumn = 34;

constexpr const char* kMainExamples = R"(Examples:
  wend generate office --size 160x100 --seed 7 -o office.yaml
  wend info office.yaml
  wend plan office.yaml --start 1,1 --goal 15,9 --robot-radius 0.2 -o plan.png

`wend SUBCOMMAND --help` describes each subcommand.)";

struct NamedCommand {
  std::string_view name;
  Command (*add)(Parser& app);
};

constexpr std::array kCommands{
    NamedCommand{"plan", add_plan},         NamedCommand{"smooth", add_smooth},
    NamedCommand{"follow", add_follow},     NamedCommand{"explore", add_explore},
    NamedCommand{"check", add_check},       NamedCommand{"field", add_field},
    NamedCommand{"compare", add_compare},   NamedCommand{"explain", add_explain},
    NamedCommand{"view", add_view},         NamedCommand{"info", add_info},
    NamedCommand{"generate", add_generate}, NamedCommand{"convert", add_convert},
    NamedCommand{"index", add_index},       NamedCommand{"planners", add_planners}};

/// The command that the first word names, alone: to add the flags of all takes longer than most of them run. All
/// commands if it names none, but for --version, which needs none.
std::vector<Command> commands_for(Parser& app, const Invocation& invocation) {
  const std::string first = invocation.words.empty() ? std::string() : invocation.words.front();
  const auto named = std::ranges::find(kCommands, std::string_view(first), &NamedCommand::name);
  if (named != kCommands.end()) return {named->add(app)};
  if (first == "--version") return {};
  std::vector<Command> commands;
  commands.reserve(kCommands.size());
  for (const NamedCommand& command : kCommands) commands.push_back(command.add(app));
  for (Command& command : add_developer_commands(app, invocation)) {
    commands.push_back(std::move(command));
  }
  return commands;
}

std::vector<Command> add_commands(CLI::App& app, const Invocation& invocation) {
  app.set_version_flag("--version", "wend " WEND_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print what most people need and exit");
  app.set_help_all_flag("--help-all", "Print the help of every option and exit");
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->column_width(kNameColumn);
  app.require_subcommand(1);
  app.footer(kMainExamples);
  Parser parser(app);
  add_plugin_option(parser);
  return commands_for(parser, invocation);
}

int run(const Command& command) {
  try {
    return command.run();
  } catch (const InputError& error) {
    complain(error.what());
    return bad_input;
  } catch (const NoPathError& error) {
    complain(error.what());
    return no_plan;
  } catch (const std::bad_alloc&) {
    complain("not enough memory");
    return no_plan;
  }
}

/// Prints help or the version.
int show(const CLI::App& app, const CLI::ParseError& what) {
  try {
    return app.exit(what);
  } catch (const InputError& error) {  // help of a planner that does not exist
    complain(error.what());
    return bad_input;
  }
}

int run_app(int argc, char** argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  Invocation invocation{arguments, {}};
  if (const std::string wrong = load_plugins(arguments, invocation.plugins); !wrong.empty()) {
    complain(wrong);
    return bad_input;
  }
  CLI::App app("wend plans paths for robots on maps.", "wend");
  const std::vector<Command> commands = add_commands(app, invocation);
  try {
    std::ranges::reverse(arguments);  // CLI11 takes the last word first
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == EXIT_SUCCESS) return show(app, error);  // help, version
    complain(usage_error(app, error));
    return bad_input;
  }
  if (const std::string wrong = swallowed_flag(app); !wrong.empty()) {
    complain(wrong);
    return bad_input;
  }
  for (const Command& command : commands) {
    if (command.parser.parsed()) return run(command);
  }
  return bad_input;
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that closes the pipe (`wend ... | head`) must not end the program: see finish_output().
  std::signal(SIGPIPE, SIG_IGN);
  end_on_interrupt();
  try {
    const int code = run_app(argc, argv);
    if (finish_output()) return Interruptible::cancelled() ? interrupted : code;
    complain("cannot write the results to standard output");
  } catch (const std::exception& error) {
    complain(fmt::format("internal error: {}", error.what()));
  }
  return bad_input;
}
