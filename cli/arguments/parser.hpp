#pragma once

// Parser: the arguments that a program or a subcommand takes, and Argument: one of them. They pass
// everything to CLI11. Subcommands use CLI11 only through them, because each source that includes
// CLI11 compiles much of it again: see parser.cpp.

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the name is CLI11's
class App;
class Option;
}  // namespace CLI

namespace wend::cli {

/// The heading in help of what most people need, and of the rest that belongs to no other heading.
inline constexpr const char* kMainGroup = "Options";
inline constexpr const char* kFurtherGroup = "Further options";

/// Help of one of the choices of a flag, as of one planner: its options with their words.
struct HelpOfChoice {
  std::string title;
  std::vector<std::pair<std::string, std::string>> options;
};
/// Throws InputError for a choice that does not exist.
using ChoiceHelp = std::function<HelpOfChoice(const std::string& choice)>;

/// An added argument, to configure it further. A reference: copies mean the same argument.
class Argument {
 public:
  explicit Argument(CLI::Option& option) : option_(&option) {}

  Argument required() const;
  /// What it takes, as help shows it: "FILE".
  Argument type_name(const std::string& name) const;
  /// The heading in help under which it stands.
  Argument group(const std::string& name) const;
  /// Its value may be omitted and is then empty. It follows an equals sign, `--smooth=0.1,0.3`, so that
  /// the next argument is never taken for it.
  Argument optional_value() const;
  /// An old name of another argument: accepted, unless both are given, but shown in neither help nor
  /// completion.
  Argument former_name_of(const Argument& current) const;
  /// An error if both are given.
  Argument excludes(const Argument& other) const;
  /// Takes one value each time that it is given.
  Argument one_at_a_time() const;
  /// Takes one word each time that it is given, with several values between commas.
  Argument separated_by_commas() const;

 private:
  CLI::Option* option_;
};

/// Adds arguments. Values are assigned while the command line is parsed, so what they refer to must
/// outlive that. A reference: copies add to the same command.
class Parser {
 public:
  using AssignText = std::function<void(const std::string&)>;
  using AssignTexts = std::function<void(const std::vector<std::string>&)>;
  using AssignCount = std::function<void(std::int64_t)>;

  explicit Parser(CLI::App& app) : app_(&app) {}

  Parser add_subcommand(const std::string& name, const std::string& description);
  /// One of the subcommands must be named.
  void require_subcommand();
  /// All words that follow, also --help, are left alone: another program reads them.
  void leave_all_words();

  /// `flags` are "-o,--output", or a name without dashes for a positional argument.
  Argument add_option(const std::string& flags, std::string& value, const std::string& help);
  Argument add_option(const std::string& flags, std::vector<std::string>& values,
                      const std::string& help);
  Argument add_option(const std::string& flags, const AssignText& assign, const std::string& help);
  Argument add_list(const std::string& flags, const AssignTexts& assign, const std::string& help);

  Argument add_flag(const std::string& flags, bool& value, const std::string& help);
  /// `assign` gets how often the flag was given; a negated flag ("!--no-furniture") counts down.
  Argument add_flag(const std::string& flags, const AssignCount& assign, const std::string& help);

  /// Few people need these flags: only --help-all shows them. Those that the command does not have are ignored.
  void further(const std::vector<std::string>& flags);

  /// With a value of this flag, --help shows the help of that choice.
  void add_choice_help(const std::string& flag, const ChoiceHelp& help);

  /// What stands below the arguments in help: examples and exit codes.
  void footer(const std::string& text);

  /// Whether the command line named this subcommand.
  bool parsed() const;

  /// The name by which a flag, "--style", was given: its own or a former one. Empty if it was not
  /// given, or if the command has no such flag.
  std::string typed(const std::string& flag) const;
  bool given(const std::string& flag) const { return !typed(flag).empty(); }

  /// Leaves this subcommand out of help, completion, suggestions and the reference.
  void hide();

  /// For the sources that walk over all that was added: completion, reference and usage errors.
  const CLI::App& app() const { return *app_; }

 private:
  CLI::App* app_;
};

/// The subcommands that are not hidden, in the order in which they were added.
std::vector<const CLI::App*> visible_subcommands(const CLI::App& app);

/// Ends parsing with an error: the value of this flag is wrong.
[[noreturn]] void refuse_value(const std::string& flags, const std::string& what);

}  // namespace wend::cli
