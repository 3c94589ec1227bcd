#pragma once

// The developers' commands, one source file each.

#include <string>
#include <vector>

#include "cli/commands/command.hpp"

namespace wend::cli {

Command add_bench(Parser& app);

/// `plugins` are the files that were loaded.
Command add_test_planner(Parser& app, const std::vector<std::string>& plugins);

/// Completes the subcommands that have been added to `app` before.
Command add_completion(Parser& app);

/// Hidden: describes the subcommands of `app` as JSON.
Command add_reference(Parser& app);

}  // namespace wend::cli
