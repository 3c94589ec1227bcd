#pragma once

// The commands that most users never need: bench, test-planner, completion, and the hidden reference. They and what
// they link would be a fifth of the program's build and most of its start. So there are two programs from the
// sources of cli/: wend-bench has all commands; wend hands these to the wend-bench beside it.

#include <string>
#include <vector>

#include "cli/commands/command.hpp"

namespace wend::cli {

inline constexpr const char* kBenchDescription = "Solve, time and check MovingAI scenarios";
inline constexpr const char* kTestPlannerDescription =
    "Hold a planner to its guarantee on random maps";
inline constexpr const char* kCompletionDescription =
    "Print a script that completes wend in a shell";
inline constexpr const char* kReferenceDescription =
    "Describe every subcommand and option, as JSON";

/// How the program was started.
struct Invocation {
  std::vector<std::string> words;    // of the command line, without the program
  std::vector<std::string> plugins;  // the files that were loaded
};

/// Call it last: completion and reference describe the commands that are there.
std::vector<Command> add_developer_commands(Parser& app, const Invocation& invocation);

}  // namespace wend::cli
