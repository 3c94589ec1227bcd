// wend completion: scripts that complete wend's command line in a shell.

#include <CLI/App.hpp>
#include <algorithm>
#include <cctype>
#include <memory>
#include <utility>

#include "cli/arguments/drive_arguments.hpp"
#include "cli/arguments/flags.hpp"
#include "cli/commands/developer_commands.hpp"
#include "cli/developers/completion_scripts.hpp"
#include "cli/developers/developers.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "wend/analysis/layer.hpp"
#include "wend/generate/generators.hpp"
#include "wend/path/smoothing/smoother.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/style.hpp"

namespace wend::cli {
namespace {

enum class Shell { bash, zsh, fish };

constexpr const char* kCompletionExamples = R"(Examples:
  wend completion bash > ~/.local/share/bash-completion/completions/wend
  wend completion zsh > "${fpath[1]}/_wend"
  wend completion fish > ~/.config/fish/completions/wend.fish
  source <(wend completion bash)    # for this shell only)";

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == separator) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

template <class Value>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for (const auto& choice : choice_names(Value{})) names.emplace_back(choice.name);
  return names;
}

bool is_lower_case_of(std::string_view name, std::string_view type) {
  return std::ranges::equal(name, type, {}, {}, [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
}

/// The choices of all planners if the type is an option's name, as in OptionFlags.
std::vector<std::string> choices_of_planners(const std::string& type) {
  std::vector<std::string> choices;
  for (const PlannerInfo& planner : planners()) {
    for (const OptionInfo& option : planner.options) {
      if (!is_lower_case_of(option.name, type)) continue;
      for (const std::string& choice : option.choices) {
        if (std::ranges::find(choices, choice) == choices.end()) choices.push_back(choice);
      }
    }
  }
  return choices;
}

/// The words among what may follow a flag; placeholders are in capitals.
std::vector<std::string> words_of_optional(const std::string& inner) {
  if (inner.starts_with(kControllerType)) return controller_names();
  std::vector<std::string> words = split(inner, '|');
  std::erase_if(words, [](const std::string& word) {
    return word.empty() || std::isupper(static_cast<unsigned char>(word.front())) != 0;
  });
  return words;
}

/// The words that complete a value of that type; empty if files do, or nothing does.
std::vector<std::string> words_of(const std::string& type) {
  if (type.starts_with('[')) return words_of_optional(type.substr(1, type.size() - 2));
  if (type == kPlannerType) return planners().names();
  if (type == kSmootherType) return smoothers().names();
  if (type == kControllerType) return controller_names();
  if (type == kGeneratorType) return generators().names();
  if (type == kLayerType) return names_of<LayerKind>();
  if (type == kStyleType) return names_of<StyleName>();
  return type.find('|') == std::string::npos ? choices_of_planners(type) : split(type, '|');
}

/// A flag's help up to the first bracket or colon.
std::string in_short(std::string help) {
  std::replace(help.begin(), help.end(), '\n', ' ');
  help.erase(std::min(help.find_first_of(";:("), help.size()));
  help.erase(help.find_last_not_of(' ') + 1);
  return help;
}

CompletedArgument argument_of(const CLI::Option& option) {
  CompletedArgument argument;
  for (const std::string& name : option.get_snames()) argument.flags.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) argument.flags.push_back("--" + name);
  argument.help = in_short(option.get_description());
  argument.takes_value = option.get_items_expected_max() > 0;
  argument.takes_many = option.get_items_expected_max() > 1;
  argument.words = words_of(option.get_type_name());
  argument.is_file = option.get_type_name() == kFileType;
  return argument;
}

bool has_flag(const Subcommand& subcommand, const CompletedArgument& flag) {
  return std::ranges::find(subcommand.flags, flag.flags, &CompletedArgument::flags) !=
         subcommand.flags.end();
}

void add_arguments(Subcommand& subcommand, const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // a former name
    CompletedArgument argument = argument_of(*option);
    if (!option->nonpositional()) {
      subcommand.positionals.push_back(std::move(argument));
    } else if (!has_flag(subcommand, argument)) {
      subcommand.flags.push_back(std::move(argument));
    }
  }
}

/// If the subcommand has subcommands, their names become choices of its first argument, besides that
/// argument's own words, and the flags of all of them become its flags.
void add_subcommands(Subcommand& subcommand, const CLI::App& app) {
  if (visible_subcommands(app).empty()) return;
  CompletedArgument choice;
  choice.help = "what to do";
  for (const CompletedArgument& own : std::exchange(subcommand.positionals, {}))
    choice.words = own.words;
  for (const CLI::App* each : visible_subcommands(app)) {
    choice.words.push_back(each->get_name());
    add_arguments(subcommand, *each);
  }
  subcommand.positionals.resize(std::min<std::size_t>(1, subcommand.positionals.size()));
  subcommand.positionals.insert(subcommand.positionals.begin(), std::move(choice));
}

std::vector<Subcommand> subcommands_of(const CLI::App& app) {
  std::vector<Subcommand> subcommands;
  for (const CLI::App* each : visible_subcommands(app)) {
    Subcommand subcommand{each->get_name(), each->get_description(), {}, {}};
    add_arguments(subcommand, *each);
    add_subcommands(subcommand, *each);
    subcommands.push_back(std::move(subcommand));
  }
  return subcommands;
}

int run(const CLI::App& app, Shell shell) {
  const std::vector<Subcommand> subcommands = subcommands_of(app);
  switch (shell) {
    case Shell::bash:
      print(bash_completion(subcommands));
      break;
    case Shell::zsh:
      print(zsh_completion(subcommands));
      break;
    case Shell::fish:
      print(fish_completion(subcommands));
      break;
  }
  return success;
}

}  // namespace

Command add_completion(Parser& app) {
  Parser completion = app.add_subcommand("completion", kCompletionDescription);
  const auto shell = std::make_shared<Shell>(Shell::bash);
  add_choice<Shell>(completion, "SHELL", *shell,
                    {{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}},
                    "The shell")
      .required();
  completion.footer(kCompletionExamples);
  return {completion, [app, shell] { return run(app.app(), *shell); }};
}

}  // namespace wend::cli
