// The developers' commands themselves, for wend-bench.

#include "cli/commands/developer_commands.hpp"
#include "cli/developers/developers.hpp"

namespace wend::cli {

std::vector<Command> add_developer_commands(Parser& app, const Invocation& invocation) {
  std::vector<Command> commands{add_bench(app), add_test_planner(app, invocation.plugins)};
  commands.push_back(add_completion(app));
  commands.push_back(add_reference(app));
  return commands;
}

}  // namespace wend::cli
