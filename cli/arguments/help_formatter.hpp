#pragma once

// HelpFormatter: what help shows. --help has what most people need and fits on two screens; --help-all has every
// argument; with the name of a planner (or its like), --help has the options of that one.
//
// An argument reads "-o, --output FILE", "--in-place, --no-in-place", "--smooth[=ALPHA,BETA]" for an
// optional value. Spellings with underscores are accepted, but not shown.

#include <CLI/Formatter.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/arguments/parser.hpp"

namespace wend::cli {

/// The spellings of an option that help shows: "-o", "--output".
std::vector<std::string> shown_names(const CLI::Option& option);

/// The options of an app's group that are not hidden, in the order in which they were added.
std::vector<const CLI::Option*> options_in(const CLI::App& app, const std::string& group);

class HelpFormatter : public CLI::Formatter {
 public:
  /// With a value of this flag (a planner's name), --help shows the help of that choice alone.
  void add_choice_help(const CLI::App& app, const std::string& flag, ChoiceHelp help);

  /// Throws InputError where a choice does not exist.
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;

 private:
  struct Choice {
    const CLI::App* app;
    std::string flag;
    ChoiceHelp help;
  };

  std::string help_of_choices(const CLI::App& app, const std::string& name) const;
  std::string brief_help(const CLI::App& app, const std::string& name) const;
  std::string brief_options(const CLI::App& app) const;
  std::string where_the_rest_is(const CLI::App& app, const std::string& name) const;

  std::vector<Choice> choices_;
};

}  // namespace wend::cli
