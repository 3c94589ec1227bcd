#pragma once

// Where a path collides, for people.

#include <string>

#include "cli/arguments/coordinates.hpp"
#include "wend/path/path_collision.hpp"

namespace wend::cli {

/// "after 3.21 m, at (1.2,3.4) m, cell (24,68), it enters an obstacle: that at ..."
std::string collision_text(const PathCollision& collision, const Coordinates& coordinates);

}  // namespace wend::cli
