#pragma once

// OptionFlags: the options of planners (or generators) as flags, made at run time from their
// schemas. An option "corner_rule" is the flag --corner-rule, or --corner_rule; a yes-or-no option
// "furniture" is --furniture and --no-furniture. Options of the same name share a flag;
// if their choices differ, help shows the value as the option's name: --heuristic HEURISTIC.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/arguments/parser.hpp"
#include "wend/base/options.hpp"

namespace wend::cli {

class OptionFlags {
 public:
  /// `kind` is what owners are called: "planner".
  explicit OptionFlags(std::string kind) : kind_(std::move(kind)) {}
  ~OptionFlags() = default;
  OptionFlags(const OptionFlags&) = delete;  // the app's callbacks point here
  OptionFlags& operator=(const OptionFlags&) = delete;

  /// Collects the options of one owner; the name is empty if it is the only one.
  void collect(const std::string& owner, const std::vector<OptionInfo>& options);

  /// Options of an owner for which the command has flags of its own: only help_of() names them.
  void mention(const std::string& owner, const std::vector<OptionInfo>& options);

  /// Adds a flag for every option collected. With `choice`, the flag that names the owner ("--planner"), its --help
  /// has the options of that owner alone.
  void add_to(Parser& app, const std::string& choice = {});

  /// The options given, by their names. Throws InputError for one that the owner does not have and for
  /// a number that is out of its range.
  OptionValues values_for(const std::string& owner) const;

  /// The last value that was typed for an option of this name; nothing if it was not given.
  std::optional<std::string> given(std::string_view name) const;

 private:
  struct Flag {
    std::string name;
    std::string former;
    std::vector<std::string> owners;
    std::vector<OptionInfo> options;  // of each owner
  };

  void add_flag(Parser& app, const Flag& flag);
  HelpOfChoice help_of(const std::string& choice) const;
  std::string group() const;
  const Flag* find(const std::string& name) const;

  std::string kind_;
  std::vector<Flag> flags_;
  std::vector<std::string> owners_;
  std::vector<std::pair<std::string, OptionInfo>> mentioned_;  // whose
  OptionValues given_;
};

}  // namespace wend::cli
