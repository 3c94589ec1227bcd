#pragma once

// A path that is read from a file, for the map it belongs to.

#include <string>

#include "cli/arguments/parser.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/map/free_space.hpp"

namespace wend::cli {

/// The positional PATH.
void add_path_file(Parser& app, std::string& file);

/// Throws InputError if it cannot be read, NoPathError if it says why there is no path.
Path load_path_for(const FreeSpace& space, const std::string& file, PathStage stage);

/// The same, also if something of it does not lie on the map.
Path load_path_on(const FreeSpace& space, const std::string& file, PathStage stage);

}  // namespace wend::cli
