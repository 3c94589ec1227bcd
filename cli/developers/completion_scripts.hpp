#pragma once

// Completion scripts for shells, from what the program's subcommands take.

#include <string>
#include <vector>

namespace wend::cli {

/// A flag or a positional argument.
struct CompletedArgument {
  std::vector<std::string> flags;  // every spelling, dashes included
  std::string help;                // a few words
  bool takes_value = false;
  bool takes_many = false;         // positional: the rest of the line is all this
  std::vector<std::string> words;  // the possible values; empty: any value
  bool is_file = false;
};

struct Subcommand {
  std::string name;
  std::string help;
  std::vector<CompletedArgument> flags;
  std::vector<CompletedArgument> positionals;
};

std::string bash_completion(const std::vector<Subcommand>& subcommands);
std::string zsh_completion(const std::vector<Subcommand>& subcommands);
std::string fish_completion(const std::vector<Subcommand>& subcommands);

}  // namespace wend::cli
