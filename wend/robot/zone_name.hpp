#pragma once

// The masks that block cells which are free without them.

#include <optional>
#include <string>

#include "wend/geometry/cell.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The name of the mask, if one blocks a cell of the map that is free without it; empty if the mask has none.
std::optional<std::string> mask_at(const FreeSpace& space, Cell cell);

/// "the keep-out mask 'depot.yaml'", or "a keep-out mask" without a name.
std::string mask_text(const std::string& name);

}  // namespace wend
