// The developers' commands of wend: each starts wend-bench, which has them, with the same command line.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "cli/commands/developer_commands.hpp"
#include "cli/exit_code.hpp"

namespace wend::cli {
namespace {

std::filesystem::path wend_bench() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  return program.parent_path() / "wend-bench";
}

/// Becomes wend-bench. Throws InputError if that is not there.
int hand_over(const std::string& command, const std::vector<std::string>& words) {
  const std::string program = wend_bench().string();
  std::vector<std::string> strings{program};
  strings.insert(strings.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  arguments.reserve(strings.size() + 1);
  for (std::string& word : strings) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  throw InputError(fmt::format(
      "`wend {}` needs the program {}, which cannot be started: {} (`./run build` makes it)",
      command, program, std::error_code(errno, std::generic_category()).message()));
}

Command handed_over(Parser& app, const Invocation& invocation, const std::string& name,
                    const std::string& description) {
  Parser command = app.add_subcommand(name, description);
  command.leave_all_words();
  return {command, [name, words = invocation.words] { return hand_over(name, words); }};
}

}  // namespace

std::vector<Command> add_developer_commands(Parser& app, const Invocation& invocation) {
  std::vector<Command> commands{
      handed_over(app, invocation, "bench", kBenchDescription),
      handed_over(app, invocation, "test-planner", kTestPlannerDescription),
      handed_over(app, invocation, "completion", kCompletionDescription),
      handed_over(app, invocation, "reference", kReferenceDescription)};
  commands.back().parser.hide();
  return commands;
}

}  // namespace wend::cli
