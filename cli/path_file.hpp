#pragma once

// A path that was read from a file, for the map it belongs to.

#include <string>

#include "wend/io/load_path.hpp"
#include "wend/map/free_space.hpp"

namespace wend::cli {

/// Throws InputError if it cannot be read.
Path load_path_for(const FreeSpace& space, const std::string& file, PathStage stage);

/// The same, also if something of it does not lie on the map.
Path load_path_on(const FreeSpace& space, const std::string& file, PathStage stage);

}  // namespace wend::cli
