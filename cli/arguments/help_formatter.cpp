#include "cli/arguments/help_formatter.hpp"

#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>

#include "cli/arguments/flags.hpp"

namespace wend::cli {
namespace {

constexpr std::ptrdiff_t kTwoScreens = 50;  // lines
constexpr std::size_t kBriefWidth = 92;     // two lines beside the name
constexpr std::ptrdiff_t kFewestExamples = 2;
constexpr std::ptrdiff_t kMostExamples = 6;

std::ptrdiff_t lines_in(std::string_view text) { return std::ranges::count(text, '\n'); }

/// As many sentences, or parts of the first one, as fit on two lines; at least the first part.
std::string in_brief(const std::string& help) {
  constexpr std::array<std::string_view, 4> kEnds{". ", "; ", " (", ": "};
  const std::string text = unwrapped(help);
  if (text.size() <= kBriefWidth) return help;
  std::size_t best = std::string::npos;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::string_view rest = std::string_view(text).substr(at);
    const bool ends =
        std::ranges::any_of(kEnds, [&](std::string_view end) { return rest.starts_with(end); });
    if (!ends) continue;
    if (best != std::string::npos && at > kBriefWidth) break;
    best = at;
  }
  return wrapped(text.substr(0, best));
}

/// The first examples of a footer, as many as there is room for, below their heading.
std::string some_examples(std::string_view footer, std::ptrdiff_t room) {
  std::string text;
  const std::ptrdiff_t most = std::clamp(room, kFewestExamples, kMostExamples);
  for (std::ptrdiff_t line = 0; line <= most && !footer.empty(); ++line) {
    const std::string_view example = footer.substr(0, footer.find('\n'));
    if (example.empty()) break;
    text += std::string(example) + "\n";
    footer.remove_prefix(std::min(example.size() + 1, footer.size()));
  }
  return text;
}

/// "planner" of "--planner", "kind" of "KIND"
std::string noun_of(std::string flag) {
  flag.erase(0, flag.find_first_not_of('-'));
  std::ranges::transform(flag, flag.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return flag;
}

/// "KIND", or "--planner NAME"
std::string as_typed(const std::string& flag) {
  return flag.starts_with('-') ? flag + " NAME" : flag;
}

}  // namespace

std::vector<std::string> shown_names(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& letter : option.get_snames()) names.push_back("-" + letter);
  for (const std::string& name : option.get_lnames()) {
    if (name.find('_') == std::string::npos) names.push_back("--" + name);
  }
  return names;
}

std::vector<const CLI::Option*> options_in(const CLI::App& app, const std::string& group) {
  return app.get_options([&group](const CLI::Option* option) {
    return option->nonpositional() && option->get_group() == group && !group.empty();
  });
}

void HelpFormatter::add_choice_help(const CLI::App& app, const std::string& flag, ChoiceHelp help) {
  choices_.push_back({&app, flag, std::move(help)});
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
  // CLI11 would add all that every subcommand has to say.
  std::string all = Formatter::make_help(app, name, CLI::AppFormatMode::Normal);
  if (mode != CLI::AppFormatMode::Normal) return all;
  std::string of_choices = help_of_choices(*app, name);
  if (!of_choices.empty()) return of_choices;
  if (lines_in(all) <= kTwoScreens) return all;
  return brief_help(*app, name);
}

std::string HelpFormatter::help_of_choices(const CLI::App& app, const std::string& name) const {
  std::string text;
  for (const Choice& choice : choices_) {
    const CLI::Option* option = choice.app == &app ? app.get_option_no_throw(choice.flag) : nullptr;
    if (option == nullptr || option->count() == 0) continue;
    const HelpOfChoice help = choice.help(option->results().back());
    std::ostringstream out;
    out << (text.empty() ? "" : "\n") << help.title << "\n";
    for (const auto& [names, words] : help.options) {
      CLI::detail::format_help(out, names, words, get_column_width());
    }
    text += out.str();
  }
  return text.empty() ? text : text + fmt::format("\nSee also `{} --help`.\n", name);
}

std::string HelpFormatter::brief_help(const CLI::App& app, const std::string& name) const {
  const std::string above = make_description(&app) + make_usage(&app, name) +
                            make_positionals(&app) + brief_options(app) +
                            make_subcommands(&app, CLI::AppFormatMode::Normal) + "\n";
  const std::string below = "\n" + where_the_rest_is(app, name);
  const std::ptrdiff_t room = kTwoScreens - lines_in(above) - lines_in(below) - 1;
  return above + some_examples(app.get_footer(), room) + below;
}

std::string HelpFormatter::brief_options(const CLI::App& app) const {
  std::ostringstream out;
  out << "\nOptions:\n";
  for (const CLI::Option* option : options_in(app, kMainGroup)) {
    CLI::detail::format_help(out, make_option_name(option, false) + make_option_opts(option),
                             in_brief(option->get_description()), get_column_width());
  }
  return out.str();
}

std::string HelpFormatter::where_the_rest_is(const CLI::App& app, const std::string& name) const {
  std::size_t others = 0;
  for (const std::string& group : app.get_groups()) {
    if (group != kMainGroup) others += options_in(app, group).size();
  }
  std::string text = fmt::format("`{} --help-all` says all about these", name);
  if (others > 0) text += fmt::format(" and {} more options", others);
  for (const Choice& choice : choices_) {
    if (choice.app != &app) continue;
    text += fmt::format(";\n`{} {} --help` has the options of one {}", name, as_typed(choice.flag),
                        noun_of(choice.flag));
  }
  return text + ".\n";
}

std::string HelpFormatter::make_option_name(const CLI::Option* option, bool is_positional) const {
  if (is_positional) return option->get_name(true, false);
  return fmt::format("{}", fmt::join(shown_names(*option), ", "));
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  std::string type = option->get_type_name();
  if (type.empty()) return {};  // a flag
  const bool value_is_optional = option->get_items_expected_max() == 0;
  if (value_is_optional) return type.insert(1, 1, '=');
  type.insert(0, 1, ' ');
  if (option->get_expected_max() == CLI::detail::expected_max_vector_size) type += " ...";
  return type + (option->get_required() ? " (required)" : "");
}

}  // namespace wend::cli
