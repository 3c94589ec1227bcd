#pragma once

// --nearest: from or to the nearest free cell, where the start or the goal is blocked.

#include <string>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "cli/output/explainer.hpp"
#include "wend/map/free_space.hpp"

namespace wend::cli {

/// Moves blocked ends to the nearest passable cells that are connected to the other end; says so,
/// a line for each. Ends outside the map stay where they are.
std::vector<std::string> move_to_nearest(Ends& ends, const FreeSpace& space,
                                         const Coordinates& coordinates, GridMoves moves);

}  // namespace wend::cli
