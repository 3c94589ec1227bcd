#pragma once

// What the commands that save maps have in common: a map.yaml's picture never replaces a file
// that belongs to something else, and every written file is named.

#include <string>
#include <vector>

#include "cli/arguments/parser.hpp"

namespace wend::cli {

/// --force
void add_force(Parser& app, bool& force);

/// Throws InputError if saving a map under this name would replace a picture that no map.yaml of
/// this name names. `name` is what the message calls the file.
void check_picture(const std::string& file, const std::string& name);

/// Throws InputError if --force was given and none of these names is that of a map.yaml.
void check_force(const Parser& command, const std::vector<std::string>& names);

/// The files that saving a map under each of these names writes, each once.
std::vector<std::string> files_of_maps(const std::vector<std::string>& names);

}  // namespace wend::cli
