#pragma once

// Explanations in the words of the command line: the library's sentences with the names of the options.

#include "cli/arguments/coordinates.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/explainer.hpp"

namespace wend::cli {

/// What explanations call the options of the command line.
Hints command_line_hints();

/// Explains in the user's units, for a planner that moves so.
Explainer explainer_for(const FreeSpace& space, const Coordinates& coordinates, GridMoves moves);

}  // namespace wend::cli
