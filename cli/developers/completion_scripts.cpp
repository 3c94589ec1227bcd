#include "cli/developers/completion_scripts.hpp"

#include <fmt/format.h>

#include <string_view>

namespace wend::cli {
namespace {

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

/// Removes the characters that shells interpret inside quotes and brackets.
std::string plain(const std::string& text) {
  std::string kept;
  for (const char letter : text) {
    if (std::string_view("'\"`\\[]:$").find(letter) == std::string_view::npos) kept += letter;
  }
  return kept;
}

std::string subcommand_names(const std::vector<Subcommand>& subcommands) {
  std::vector<std::string> names;
  names.reserve(subcommands.size());
  for (const Subcommand& subcommand : subcommands) names.push_back(subcommand.name);
  return joined(names, " ");
}

/// `"plan --planner" | ...) words="astar bfs" ;;` for each flag with words.
std::string bash_values(const Subcommand& subcommand) {
  std::string cases;
  for (const CompletedArgument& flag : subcommand.flags) {
    if (!flag.takes_value) continue;
    std::string patterns;
    for (const std::string& name : flag.flags) {
      patterns += fmt::format("{}'{} {}'", patterns.empty() ? "" : " | ", subcommand.name, name);
    }
    cases += fmt::format("    {}) words='{}' value=yes ;;\n", patterns, joined(flag.words, " "));
  }
  return cases;
}

std::string bash_flags(const Subcommand& subcommand) {
  std::vector<std::string> flags;
  for (const CompletedArgument& flag : subcommand.flags) {
    flags.insert(flags.end(), flag.flags.begin(), flag.flags.end());
  }
  std::vector<std::string> words;
  for (const CompletedArgument& positional : subcommand.positionals) {
    words.insert(words.end(), positional.words.begin(), positional.words.end());
  }
  return fmt::format("    {}) flags='{}' words='{}' ;;\n", subcommand.name, joined(flags, " "),
                     joined(words, " "));
}

std::string zsh_action(const CompletedArgument& argument) {
  if (!argument.words.empty()) return fmt::format("({})", joined(argument.words, " "));
  return argument.is_file ? "_files" : " ";
}

/// One line of _arguments for each spelling.
std::string zsh_flag(const CompletedArgument& flag) {
  std::string lines;
  for (const std::string& name : flag.flags) {
    const std::string value = flag.takes_value ? ":value:" + zsh_action(flag) : "";
    lines += fmt::format(" \\\n        '*{}[{}]{}'", name, plain(flag.help), value);
  }
  return lines;
}

std::string fish_line(const Subcommand& subcommand, const std::string& rest) {
  return fmt::format("complete -c wend -n '__fish_seen_subcommand_from {}' {}\n", subcommand.name,
                     rest);
}

std::string fish_flag(const CompletedArgument& flag) {
  std::string spellings;
  for (const std::string& name : flag.flags) {
    const bool is_long = name.starts_with("--");
    spellings += fmt::format("{} {} ", is_long ? "-l" : "-s", name.substr(is_long ? 2 : 1));
  }
  std::string value;
  if (!flag.words.empty()) value = fmt::format("-x -a '{}' ", joined(flag.words, " "));
  if (flag.words.empty() && flag.takes_value) value = flag.is_file ? "-r -F " : "-x ";
  return fmt::format("{}{}-d '{}'", spellings, value, plain(flag.help));
}

}  // namespace

std::string bash_completion(const std::vector<Subcommand>& subcommands) {
  std::string flags;
  std::string values;
  for (const Subcommand& subcommand : subcommands) {
    flags += bash_flags(subcommand);
    values += bash_values(subcommand);
  }
  return fmt::format(R"(# bash completion for wend
_wend() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}}
  local flags='' words='' value='' before=''
  if [[ $current == '=' ]]; then
    current=''
  elif [[ $previous == '=' ]]; then
    previous=${{COMP_WORDS[COMP_CWORD-2]}}
  fi
  if [[ $COMP_CWORD -eq 1 ]]; then
    COMPREPLY=($(compgen -W '{} --help --version' -- "$current"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  case "${{COMP_WORDS[1]}} $previous" in
{}  esac
  if [[ -z $value && $current == -* ]]; then words=$flags; fi
  if [[ -n $value && $current == *,* ]]; then before=${{current%,*}},; fi
  COMPREPLY=($(compgen -P "$before" -W "$words" -- "${{current#"$before"}}"))
}}
complete -o bashdefault -o default -F _wend wend
)",
                     subcommand_names(subcommands), flags, values);
}

std::string zsh_completion(const std::vector<Subcommand>& subcommands) {
  std::string names;
  std::string cases;
  for (const Subcommand& subcommand : subcommands) {
    names += fmt::format("    '{}:{}'\n", subcommand.name, plain(subcommand.help));
    std::string arguments;
    for (const CompletedArgument& flag : subcommand.flags) arguments += zsh_flag(flag);
    for (const CompletedArgument& positional : subcommand.positionals) {
      arguments += fmt::format(" \\\n        '{}:{}:{}'", positional.takes_many ? "*" : "",
                               plain(positional.help), zsh_action(positional));
    }
    cases += fmt::format("    {})\n      _arguments{} ;;\n", subcommand.name, arguments);
  }
  return fmt::format(R"(#compdef wend
_wend() {{
  local -a subcommands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe subcommand subcommands
    return
  fi
  local subcommand=$words[2]
  shift words
  (( CURRENT-- ))
  case $subcommand in
{}  esac
}}
if [[ $funcstack[1] == _wend ]]; then _wend "$@"; else compdef _wend wend; fi
)",
                     names, cases);
}

std::string fish_completion(const std::vector<Subcommand>& subcommands) {
  std::string text = "# fish completion for wend\n";
  for (const Subcommand& subcommand : subcommands) {
    text += fmt::format("complete -c wend -f -n __fish_use_subcommand -a {} -d '{}'\n",
                        subcommand.name, plain(subcommand.help));
    for (const CompletedArgument& flag : subcommand.flags)
      text += fish_line(subcommand, fish_flag(flag));
    for (const CompletedArgument& positional : subcommand.positionals) {
      if (positional.words.empty()) continue;
      text += fish_line(subcommand, fmt::format("-f -a '{}'", joined(positional.words, " ")));
    }
  }
  return text;
}

}  // namespace wend::cli
