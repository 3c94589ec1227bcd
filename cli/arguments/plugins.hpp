#pragma once

// --plugin: planners from shared objects. It may stand before or behind the subcommand, and is read before
// all else, because help, completion and every command list the planners.

#include <string>
#include <vector>

#include "cli/arguments/parser.hpp"

namespace wend::cli {

/// Loads what `--plugin FILE` names, adds these names to `files` and removes the words. The first error, or an empty
/// text.
std::string load_plugins(std::vector<std::string>& arguments, std::vector<std::string>& files);

/// For the help.
void add_plugin_option(Parser& app);

}  // namespace wend::cli
